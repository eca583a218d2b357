#include "proofs/checker/arithmetic/abelian_group.hpp"

#include <gtest/gtest.h>

#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/samples.hpp"

namespace delcert::checker_tests {
namespace {

using checker::group_text;
using checker::is_group;

TEST(AbelianGroup, has_one_spelling) {
  EXPECT_EQ(group_text(0, {}), "0");
  EXPECT_EQ(group_text(1, {}), "Z");
  EXPECT_EQ(group_text(2, {"2", "2", "6"}), "Z^2 + (Z/2)^2 + Z/6");
  for (const char* text : {"0", "Z", "Z^2", "Z^10", "Z/2", "(Z/2)^3", "Z + Z/2", "Z^2 + (Z/3)^2 + Z/6 + (Z/60)^7"})
    EXPECT_TRUE(is_group(text)) << text;
  for (const char* text :
       {"",          "z",          "Z^1",        "Z^0",       "Z^02",      "Z + Z",   "Z + 0",   "0 + Z",
        "Z/1",       "Z/0",        "Z/02",       "(Z/2)^1",   "(Z/2)",     "(Z/2)^0", "Z/2 + Z", "Z/2 + Z/2",
        "Z/4 + Z/2", "Z/2 + Z/3",  "Z/-2",       "Z+Z/2",     "Z  + Z/2",  " Z",      "Z ",      "Z + ",
        "Z^",        "Z/",         "(Z/2",       "(Z)^2",     "Z^2^2",     "Z/2/2",   "Z^2 Z",   "Z\\u0020",
        "verified",  "Z verified", "Z\nlevel 6", "Z\xc2\x9b", "\\u009b2J", "Z^1e3",   "Z/0x2",   "Z^2 +Z/2"}) {
    EXPECT_FALSE(is_group(text)) << text;
  }
  EXPECT_TRUE(is_group("Z/" + std::string(1000, '7')));
  EXPECT_FALSE(is_group("Z/" + std::string(1001, '7')));
}

TEST(AbelianGroup, in_a_certificate_is_one_and_no_other_text_comes_back) {
  for (const std::string text : {"verified: levels 0 1 2 3 4 5 6", "Z + Z", "Z\xc2\x9b", "Z\\u001b[2J", ""}) {
    Json document = circle().document();
    std::string bytes = sealed(document);
    bytes.replace(bytes.find("\"closed\":true"), 13, "\"closed\":true,\"homology\":[\"Z\",\"" + text + "\"]");
    const CheckerRun run = run_checker_with(temporary_file(resealed(bytes)));
    EXPECT_EQ(run.status, 3) << run.output;
    EXPECT_EQ(run.output.find("verified"), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("form.types"), std::string::npos) << run.output;
    EXPECT_EQ(run.output.find('\x9b'), std::string::npos) << run.output;
  }
}

}  // namespace
}  // namespace delcert::checker_tests
