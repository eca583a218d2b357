#include "proofs/formula/hull_angle.hpp"

#include <gtest/gtest.h>

#include "tests/support/ratio.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;

SymmetricMatrix<Rational> matrix(const Rational& a, const Rational& b, const Rational& c) {
  SymmetricMatrix<Rational> result(2);
  result(0, 0) = a;
  result(1, 0) = b;
  result(1, 1) = c;
  return result;
}

TEST(HullAngle, of_one_direction_is_a_quotient) {
  SymmetricMatrix<Rational> across(1);
  across(0, 0) = Rational(9);
  SymmetricMatrix<Rational> gram(1);
  gram(0, 0) = Rational(25);
  const auto bounds = greatest_squared_sine(across, gram, 10);
  ASSERT_TRUE(bounds.has_value());
  EXPECT_EQ(bounds->lower, ratio(9, 25));
  EXPECT_EQ(bounds->upper, ratio(9, 25));
}

/// det(A − λG) = (1/3 − λ)(1/7 − λ) for diagonal ones: the greatest root counts, wherever it stands.
TEST(HullAngle, of_two_directions_lies_between_the_bounds) {
  const auto gram = matrix(Rational(1), Rational(0), Rational(1));
  for (const auto& across :
       {matrix(ratio(1, 3), Rational(0), ratio(1, 7)), matrix(ratio(1, 7), Rational(0), ratio(1, 3))}) {
    const auto bounds = greatest_squared_sine(across, gram, 40);
    ASSERT_TRUE(bounds.has_value());
    EXPECT_TRUE(bounds->lower < ratio(1, 3) && ratio(1, 3) <= bounds->upper);
    EXPECT_TRUE(bounds->upper - bounds->lower <= Rational::power_of_two(-40));
  }
}

/// In another basis, A and G change, the angle does not: 1/3 again.
TEST(HullAngle, does_not_depend_on_the_basis) {
  // The basis e₁, e₁ + e₂ for A = diag(1/3, 1/7).
  const auto gram = matrix(Rational(1), Rational(1), Rational(2));
  const auto across = matrix(ratio(1, 3), ratio(1, 3), ratio(1, 3) + ratio(1, 7));
  const auto bounds = greatest_squared_sine(across, gram, 40);
  ASSERT_TRUE(bounds.has_value());
  EXPECT_TRUE(bounds->lower < ratio(1, 3) && ratio(1, 3) <= bounds->upper);
}

TEST(HullAngle, is_exact_within_the_space_and_across_it_and_undefined_without_directions) {
  const auto gram = matrix(Rational(1), Rational(0), Rational(1));
  const auto inside = greatest_squared_sine(SymmetricMatrix<Rational>(2), gram, 10);
  EXPECT_EQ(inside->upper, Rational(0));
  const auto across = greatest_squared_sine(matrix(Rational(1), Rational(0), Rational(0)), gram, 10);
  EXPECT_EQ(across->lower, Rational(1));
  const auto none = greatest_squared_sine(SymmetricMatrix<Rational>(0), SymmetricMatrix<Rational>(0), 10);
  EXPECT_EQ(none.exists(), Verdict::refuted);
  const auto degenerate =
      greatest_squared_sine(SymmetricMatrix<Rational>(2), matrix(Rational(1), Rational(1), Rational(1)), 10);
  EXPECT_EQ(degenerate.exists(), Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
