#include "kernel/number/fraction_text.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/parser.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(FractionText, has_no_denominator_of_1_and_is_never_hexadecimal) {
  EXPECT_EQ(fraction_text(Rational(0)), "0");
  EXPECT_EQ(fraction_text(Rational(-7)), "-7");
  EXPECT_EQ(fraction_text(Rational(Integer(6), Integer(-4))), "-3/2");
  EXPECT_EQ(fraction_text(Rational::power_of_two(-12)), "1/4096");
}

TEST(FractionText, is_read_as_an_end_of_a_range) {
  for (const int exponent : {-200, -12, -11, -10, 0, 12, 200}) {
    const Rational x = Rational::power_of_two(exponent);
    EXPECT_EQ(parse_range("[" + fraction_text(-x) + ", " + fraction_text(x) + "]").lower, -x);
    EXPECT_EQ(parse_range("[0, " + fraction_text(x) + "]").upper, x);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
