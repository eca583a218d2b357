#include "proofs/publication/exact_latex.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational dyadic(long numerator, long exponent) { return Rational(numerator) * Rational::power_of_two(-exponent); }

TEST(ExactLatex, sets_integers_fractions_and_dyadic_numbers) {
  EXPECT_EQ(exact_latex(Rational(-3)), "-3");
  EXPECT_EQ(exact_latex(Rational(1) / Rational(10)), "1/10");
  EXPECT_EQ(exact_latex(dyadic(3, 4)), "3/16");
  EXPECT_EQ(exact_latex(dyadic(0x237, 17)), "567 \\cdot 2^{-17}");
  EXPECT_EQ(exact_latex(dyadic(-5, 20)), "-5 \\cdot 2^{-20}");
}

TEST(ExactLatex, lets_long_numbers_be_broken) {
  EXPECT_EQ(exact_latex(Rational(1234567890123)), "123456\\allowbreak 789012\\allowbreak 3");
  EXPECT_EQ(exact_latex(Rational(1) / Rational(1000001)), "1/\\allowbreak 1000001");
}

TEST(ExactLatex, sets_exponents_of_decimals) {
  EXPECT_EQ(decimal_latex("0.25"), "0.25");
  EXPECT_EQ(decimal_latex("-6.28e-16"), "-6.28 \\cdot 10^{-16}");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
