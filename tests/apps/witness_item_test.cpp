#include "apps/witness_item.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(WitnessItem, is_found_in_witness_files_and_in_what_an_attack_printed) {
  const std::string file =
      DELCERT_SOURCE_DIR "/proofs/claims/witnesses/crude-circumradius-bound.circumradius-twin.json";
  ASSERT_EQ(witnesses_in(file).size(), 1U);
  const TemporaryFolder folder;
  const auto write = [&folder](const std::string& text) {
    std::ofstream(folder / "attack.json") << text;
    return (folder / "attack.json").string();
  };
  const std::string one = "{\"sample\":7,\"witness\":" + witness_text(witnesses_in(file).front()) + "}";
  const auto found = witnesses_in(write("{\n \"seed\": 1, \"refutations\": [" + one + ", " + one + "]}"));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found.back().conclusion, "circumradius-twin");
  EXPECT_THROW((void)witnesses_in(write("{\"seed\": 1, \"refutations\": []}")), InputError);
  EXPECT_THROW((void)witnesses_in(write("{\"seed\": 1}")), InputError);
  EXPECT_THROW((void)witnesses_in(write("{\"seed\": ")), InputError);
  EXPECT_TRUE(witnesses_in(write("{\"format\":\"delcert-certificate\"}")).empty());
  EXPECT_TRUE(witnesses_in((folder / "none").string()).empty());
}

TEST(WitnessItem, has_the_instance_and_what_the_replay_decided) {
  const std::string folder = DELCERT_SOURCE_DIR "/proofs/claims/witnesses/";
  const Witness witness = read_witness(folder + "crude-circumradius-bound.circumradius-twin.json");
  const PageItem item = witness_item(witness, replayed(witness), {"w.json", "abc"});
  EXPECT_EQ(item.data.at("kind"), "witness");
  EXPECT_EQ(item.data.at("claim"), "crude-circumradius-bound");
  EXPECT_EQ(item.data.at("bindings").at("s").at("simplex").at("points"), nlohmann::json::parse(R"([["0"],["-2"]])"));
  EXPECT_EQ(item.data.at("replay").at("hypotheses"), "proved");
  EXPECT_EQ(item.data.at("replay").at("verdict"), "refuted");
  EXPECT_FALSE(item.data.at("replay").at("text").get<std::string>().empty());
  // Of the claim itself, which holds, the same instance is no counterexample.
  Witness mended = witness;
  mended.twin = "";
  mended.text = "";
  mended.conclusion = "circumradius";
  EXPECT_EQ(witness_item(mended, replayed(mended), {"w.json", ""}).data.at("replay").at("verdict"), "proved");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
