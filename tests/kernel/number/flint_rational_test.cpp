#include "kernel/number/flint_rational.hpp"

#include <gtest/gtest.h>

#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(FlintRational, comes_back_as_it_was) {
  for (const Rational& x : {Rational(0), ratio(-7, 3), Rational::power_of_two(-200), Rational::power_of_two(90)}) {
    EXPECT_EQ(FlintRational(x).rational(), x);
    const FlintRational copy{FlintRational(x)};
    EXPECT_EQ(copy.rational(), x);
  }
}

TEST(FlintRational, is_a_coefficient) {
  fmpq_poly_t polynomial;
  fmpq_poly_init(polynomial);
  set_coefficient(polynomial, 2, ratio(-7, 3));
  EXPECT_EQ(coefficient_of(polynomial, 2), ratio(-7, 3));
  EXPECT_EQ(coefficient_of(polynomial, 1), Rational(0));
  EXPECT_EQ(coefficient_of(polynomial, 9), Rational(0));
  set_coefficient(polynomial, 2, Rational(0));
  EXPECT_EQ(fmpq_poly_degree(polynomial), -1);
  fmpq_poly_clear(polynomial);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
