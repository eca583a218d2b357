#include "proofs/certificate/stated_bounds.hpp"

#include <gtest/gtest.h>

#include "kernel/number/exact_text.hpp"
#include "tests/support/ratio.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;

TEST(StatedBounds, are_weaker_by_the_slack_and_have_few_digits) {
  const Rational slack = Rational::power_of_two(-20), step = Rational::power_of_two(-11);
  for (const Rational& x : {ratio(1, 3), Rational(1), ratio(1023, 1024), Rational::power_of_two(-300), ratio(22, 7)}) {
    const Rational below = stated_below(x), above = stated_above(x);
    EXPECT_LE(below, x * (Rational(1) - slack)) << exact_text(x);
    EXPECT_GE(above, x * (Rational(1) + slack)) << exact_text(x);
    EXPECT_GT(below, x * (Rational(1) - slack) * (Rational(1) - step)) << exact_text(x);
    EXPECT_LT(above, x * (Rational(1) + slack) * (Rational(1) + step)) << exact_text(x);
  }
}

TEST(StatedBounds, of_doubles_are_those_of_their_values) {
  EXPECT_EQ(stated_below(0.1), stated_below(Rational::exactly(0.1)));
  EXPECT_EQ(stated_above(0.1, 30), stated_above(Rational::exactly(0.1), 30));
  EXPECT_LT(stated_below(0.1), stated_below(0.1, 30));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
