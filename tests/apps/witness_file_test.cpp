#include "apps/witness_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(WitnessFile, is_known_by_how_it_begins) {
  const TemporaryFolder folder;
  const auto kind_of = [&folder](const std::string& text) {
    std::ofstream(folder / "file.json") << text;
    return witness_file((folder / "file.json").string());
  };
  EXPECT_EQ(kind_of("{\n  \"delcert_witness\": 1"), WitnessFile::witness);
  EXPECT_EQ(kind_of("{\"seed\":1}"), WitnessFile::attack);
  EXPECT_EQ(kind_of("{\"seeds\":1}"), WitnessFile::other);
  EXPECT_EQ(kind_of("{\"format\":\"delcert-certificate\",\"seed\":1}"), WitnessFile::other);
  EXPECT_EQ(kind_of(""), WitnessFile::other);
  EXPECT_EQ(witness_file((folder / "missing").string()), WitnessFile::other);
}

TEST(WitnessFile, gives_an_item_for_each_witness) {
  const std::string file =
      DELCERT_SOURCE_DIR "/proofs/claims/witnesses/crude-circumradius-bound.circumradius-twin.json";
  const std::vector<PageItem> items = witness_items(file, {"w.json", "abc"});
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items.front().data.at("file"), "w.json");
  EXPECT_EQ(items.front().data.at("replay").at("verdict"), "refuted");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
