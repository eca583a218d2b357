#include "properties/attack/ratio_guess.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delcert {
namespace DELCERT_THIS_FILE {

std::string guess(double ratio) { return ratio_guess({ratio, std::nextafter(ratio, 2 * ratio)}); }

TEST(RatioGuess, finds_the_fraction_that_a_search_comes_near_from_below) {
  EXPECT_EQ(guess(0.249999918), "looks like 1/4, not attained");
  EXPECT_EQ(guess(0.75 - 1e-7), "looks like 3/4, not attained");
  EXPECT_EQ(guess(1 - 1e-9), "looks like 1, not attained");
  EXPECT_EQ(guess(1.5 - 1e-9), "looks like 3/2, not attained");
  EXPECT_EQ(guess(0.5), "looks like 1/2");
  EXPECT_EQ(guess(1.0 / 3), "looks like 1/3");
}

TEST(RatioGuess, finds_roots_of_fractions) {
  EXPECT_EQ(guess(std::sqrt(0.5)), "looks like sqrt(1/2)");
  EXPECT_EQ(guess(std::sqrt(2.0) - 1e-8), "looks like sqrt(2), not attained");
}

TEST(RatioGuess, does_not_see_numbers_where_there_are_none) {
  EXPECT_EQ(guess(0.2498), "");       // too far from 1/4
  EXPECT_EQ(guess(0.25 + 1e-6), "");  // above it: 1/4 is no bound
  EXPECT_EQ(guess(std::exp(-1.0)), "");
  EXPECT_EQ(guess(std::acos(-1.0) / 4), "");
  EXPECT_EQ(guess(1e-37), "");
  EXPECT_EQ(guess(0), "");
  int seen = 0;
  for (int at = 0; at < 10000; ++at) seen += guess(std::fmod(0.6180339887498949 * (at + 1), 1)).empty() ? 0 : 1;
  EXPECT_GT(seen, 0);
  EXPECT_LT(seen, 40);  // about one in a thousand, in fractions and in roots
}

TEST(RatioGuess, takes_what_is_very_large_for_unbounded) {
  EXPECT_EQ(guess(4.34e34), "looks unbounded");
  EXPECT_EQ(guess(1e6 * std::exp(-1.0)), "");
  EXPECT_EQ(guess(999999.3), "");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
