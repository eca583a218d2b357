#include "kernel/number/simple_fraction.hpp"

#include <gtest/gtest.h>

#include "tests/support/ratio.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;

/// The same by trying one denominator after the other.
Rational by_trying(const Rational& x) {
  const Rational lower = x - x / Rational(64);
  for (long denominator = 1;; ++denominator) {
    const Rational candidate = Rational(ceiling_of(lower * Rational(denominator))) / Rational(denominator);
    if (candidate < x) return candidate;
  }
}

TEST(SimpleFraction, has_the_least_denominator_below) {
  for (long denominator = 1; denominator < 40; ++denominator) {
    for (long numerator = 1; numerator < 3 * denominator; ++numerator) {
      const Rational x = ratio(numerator, denominator);
      EXPECT_EQ(simple_fraction_below(x).denominator(), by_trying(x).denominator()) << numerator << "/" << denominator;
    }
  }
}

TEST(SimpleFraction, is_below_by_little) {
  for (const Rational& x : {ratio(52359, 1000000), ratio(1, 3), ratio(1, 1), ratio(64, 1), ratio(1570796, 1000000),
                            ratio(99999, 100000) * Rational::power_of_two(-200)}) {
    EXPECT_LT(simple_fraction_below(x), x);
    EXPECT_GE(simple_fraction_below(x), x - x / Rational(64));
  }
  EXPECT_EQ(simple_fraction_below(ratio(157, 1000)), ratio(5, 32));
}

TEST(SimpleFraction, a_simple_bound_that_may_be_reached_is_taken_itself) {
  EXPECT_EQ(simple_fraction_at_most(ratio(1, 20)), ratio(1, 20));
  EXPECT_EQ(simple_fraction_below(ratio(1, 20)), ratio(4, 81));
  EXPECT_EQ(simple_fraction_at_most(ratio(628319, 10000000)), simple_fraction_below(ratio(628319, 10000000)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
