#include "proofs/prover/sum_of_squares.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace delcert {
namespace DELCERT_THIS_FILE {

class SumOfSquares : public testing::Test {
 protected:
  Polynomial number(long value) const { return {ring_, Rational(value)}; }
  RingPointer ring_ = std::make_shared<const PolynomialRing>(std::vector<std::string>{"x", "y", "z"});
  Polynomial x_ = Polynomial::variable(ring_, 0);
  Polynomial y_ = Polynomial::variable(ring_, 1);
  Polynomial z_ = Polynomial::variable(ring_, 2);
};

TEST_F(SumOfSquares, is_checked_exactly) {
  const Polynomial p = x_ * x_ + number(2) * y_ * y_;
  EXPECT_TRUE(is_sum(p, {}, {{Rational(1), x_, {}}, {Rational(2), y_, {}}}));
  EXPECT_FALSE(is_sum(p, {}, {{Rational(1), x_, {}}}));
  EXPECT_FALSE(is_sum(p, {}, {{Rational(1), x_, {}}, {Rational(3), y_, {}}}));
  EXPECT_FALSE(is_sum(-p, {}, {{Rational(-1), x_, {}}, {Rational(-2), y_, {}}})) << "negative weights";
  EXPECT_TRUE(is_sum(x_ * x_ * y_ + x_, {x_, y_}, {{Rational(1), x_, {1}}, {Rational(1), number(1), {0}}}));
  EXPECT_FALSE(is_sum(x_ * x_ * y_ + x_, {y_, x_}, {{Rational(1), x_, {1}}, {Rational(1), number(1), {0}}}));
}

TEST_F(SumOfSquares, is_found_inside_the_cone) {
  // x⁴ + y⁴ + 1 − xy
  const Polynomial p = x_.power(4) + y_.power(4) + number(1) - x_ * y_;
  const auto terms = sum_of_squares(p, {});
  ASSERT_TRUE(terms.has_value());
  EXPECT_TRUE(is_sum(p, {}, *terms));
  EXPECT_TRUE(positive_sum_of_squares(p, {}).has_value());
}

TEST_F(SumOfSquares, is_found_where_the_polynomial_vanishes) {
  // AM–GM for fourth powers: all squares vanish where x² = y² = z² = 1.
  const Polynomial p = x_.power(4) + y_.power(4) + z_.power(4) + number(1) - number(4) * x_ * y_ * z_;
  const auto terms = sum_of_squares(p, {});
  ASSERT_TRUE(terms.has_value());
  EXPECT_TRUE(is_sum(p, {}, *terms));
  EXPECT_FALSE(positive_sum_of_squares(p, {}).has_value()) << "it is 0 at (1, 1, 1)";
}

TEST_F(SumOfSquares, may_need_constraints) {
  // x³ + y³ + z³ − 3xyz for x, y, z ≥ 0
  const Polynomial p = x_.power(3) + y_.power(3) + z_.power(3) - number(3) * x_ * y_ * z_;
  EXPECT_FALSE(sum_of_squares(p, {}).has_value());
  const auto terms = sum_of_squares(p, {x_, y_, z_});
  ASSERT_TRUE(terms.has_value());
  EXPECT_TRUE(is_sum(p, {x_, y_, z_}, *terms));
}

TEST_F(SumOfSquares, is_not_found_where_there_is_none) {
  EXPECT_FALSE(sum_of_squares(x_ * x_ - number(1), {}).has_value());
  EXPECT_FALSE(sum_of_squares(x_ * y_, {}).has_value());
  // Motzkin's polynomial is not negative, but no sum of squares.
  const Polynomial motzkin = x_.power(4) * y_ * y_ + x_ * x_ * y_.power(4) + number(1) - number(3) * x_ * x_ * y_ * y_;
  EXPECT_FALSE(sum_of_squares(motzkin, {}).has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
