#include "proofs/certificate/simplex_file.hpp"

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
  std::ofstream(folder / "simplices.json") << text;
  try {
    (void)read_simplices(folder / "simplices.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SimplexFile, of_a_certificate_is_its_complex) {
  const test::TemporaryFolder folder;
  small_run().write(folder / "c.json.zst");
  const PureComplex complex = read_simplices(folder / "c.json.zst");
  EXPECT_EQ(complex.count(2), small_run().run.complex.simplices().size());
  EXPECT_EQ(group_text(homology(complex)[1]), "Z^2");
}

TEST(SimplexFile, needs_nothing_but_simplices_and_reads_nothing_else) {
  const test::TemporaryFolder folder;
  const std::string simplices = R"("simplices":[[0,1,2,0,0],[0,1,3,7,0],[0,2,3,0,0],[1,2,3,0,9]])";
  for (const std::string& text :
       {"{" + simplices + "}", R"({"manifold":{"simplices":[[7,8,9,0,0]],"generators":"none"},)" + simplices +
                                   R"(,"points":[["not read"]]})"}) {
    std::ofstream(folder / "simplices.json") << text;
    const PureComplex complex = read_simplices(folder / "simplices.json");
    EXPECT_EQ(complex.euler_characteristic(), 2) << text;
  }
}

TEST(SimplexFile, that_is_malformed_is_an_error) {
  EXPECT_NE(complaint("{}").find("simplices.json: has no key \"simplices\""), std::string::npos);
  EXPECT_NE(complaint("[1]").find("has no key"), std::string::npos);
  EXPECT_NE(complaint(R"({"simplices":[]})").find("has no simplices"), std::string::npos);
  EXPECT_NE(complaint(R"({"simplices":[[0,1,2,0,0],[0,1,0]]})").find("simplices[1] has 3 integers, not 5"),
            std::string::npos);
  EXPECT_NE(complaint(R"({"simplices":[[0,1,2,0]]})").find("simplices[0] has 4 integers, not 3, 5, 7 or 9"),
            std::string::npos);
  EXPECT_NE(complaint(R"({"simplices":[[0,1,1,0,0]]})"), "");
  EXPECT_NE(complaint(R"({"simplices":[["0",1,2,0,0]]})"), "");
  EXPECT_NE(complaint(R"({"simplices":{"a":1}})"), "");
  EXPECT_NE(complaint(R"({"simplices":[[1,)"), "");
  EXPECT_EQ(complaint(R"({"simplices":[[0,1,2,0,0]]})"), "");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
