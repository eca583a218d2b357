#include "kernel/simplex/fraction_free.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace {

TEST(FractionFree, has_the_least_common_denominator) {
  Integer denominator(1);
  for (const auto& x : {Rational(1, 6), Rational(-3, 4), Rational(5), Rational(1, 2)})
    include_denominator(denominator, x);
  EXPECT_EQ(denominator, 12);
}

TEST(FractionFree, multiplies_by_a_multiple_of_the_denominator) {
  EXPECT_EQ(whole_multiple(Rational(-3, 4), Integer(12)), -9);
  EXPECT_EQ(whole_multiple(Rational(0), Integer(12)), 0);
  EXPECT_EQ(whole_multiple(Rational(7), Integer(12)), 84);
}

TEST(FractionFree, ends_with_the_determinant) {
  // Of (2 1 0; 1 3 1; 0 1 4), by minors.
  Integer a11(3), a12(1), a21(1), a22(4);
  const Integer first(2), one(1), none(0);
  eliminate(a11, first, one, one, one);
  eliminate(a12, first, one, none, one);
  eliminate(a21, first, none, one, one);
  eliminate(a22, first, none, none, one);
  EXPECT_EQ(a11, 5);
  const Integer second = a11;
  eliminate(a22, second, a21, a12, first);
  EXPECT_EQ(a22, 18);  // 2·(12 − 1) − 1·(4 − 0)
}

}  // namespace
}  // namespace delcert
