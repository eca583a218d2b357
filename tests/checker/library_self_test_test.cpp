#include "proofs/checker/program/library_self_test.hpp"

#include <gtest/gtest.h>

#include <cfenv>

namespace delcert::checker_tests {
namespace {

TEST(LibrarySelfTest, finds_nothing_whatever_the_mode_and_leaves_it) {
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const std::string fault = checker::library_self_test();
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(fault, "");
    EXPECT_EQ(after, mode);
  }
}

}  // namespace
}  // namespace delcert::checker_tests
