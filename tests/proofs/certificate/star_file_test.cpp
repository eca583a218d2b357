#include "proofs/certificate/star_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "kernel/topology/homology.hpp"
#include "support/error.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// What is wrong with a file of this text; "" if nothing is.
std::string complaint(const std::string& text) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "stars.json") << text;
  try {
    (void)read_star_complex(folder / "stars.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(StarFile, of_a_certificate_is_its_complex) {
  const test::TemporaryFolder folder;
  small_run().write(folder / "c.json.zst");
  const PureComplex complex = read_star_complex(folder / "c.json.zst");
  EXPECT_EQ(complex.count(2), small_run().run.complex.simplices().size());
  EXPECT_EQ(group_text(homology(complex)[1]), "Z^2");
}

TEST(StarFile, needs_nothing_but_stars_and_reads_nothing_else) {
  const test::TemporaryFolder folder;
  const std::string stars =
      R"("stars":[[[1,2],[1,3],[2,3]],[[0,2],[0,3],[2,3]],[[0,1],[0,3],[1,3]],[[0,1],[0,2],[1,2]]])";
  for (const std::string& text : {"{" + stars + "}", R"({"manifold":{"stars":[[[7]]],"generators":"none"},)" + stars +
                                                         R"(,"points":[["not read"]]})"}) {
    std::ofstream(folder / "stars.json") << text;
    const PureComplex complex = read_star_complex(folder / "stars.json");
    EXPECT_EQ(complex.euler_characteristic(), 2) << text;
  }
}

TEST(StarFile, that_is_malformed_is_an_error) {
  EXPECT_NE(complaint("{}").find("stars.json: has no key \"stars\""), std::string::npos);
  EXPECT_NE(complaint("[1]").find("has no key"), std::string::npos);
  EXPECT_NE(complaint(R"({"stars":[]})").find("no simplex"), std::string::npos);
  EXPECT_NE(complaint(R"({"stars":[[[1,2]],[[0]],[]]})").find("stars[1] has a simplex with 1 other labels, not 2"),
            std::string::npos);
  EXPECT_NE(complaint(R"({"stars":[[[1,2]],[[0,2]]]})").find("stars[0] has label 2 of 2"), std::string::npos);
  EXPECT_NE(complaint(R"({"stars":[[[1,1]],[]]})"), "");
  EXPECT_NE(complaint(R"({"stars":[[["1",2]]]})"), "");
  EXPECT_NE(complaint(R"({"stars":[[[1,)"), "");
  EXPECT_EQ(complaint(R"({"stars":[[[1,2]],[],[]]})"), "");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
