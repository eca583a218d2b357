#include "kernel/formula/polynomial.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/ratio.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;

class Polynomials : public testing::Test {
 protected:
  RingPointer ring_ = std::make_shared<const PolynomialRing>(std::vector<std::string>{"x", "y"});
  Polynomial x_ = Polynomial::variable(ring_, 0);
  Polynomial y_ = Polynomial::variable(ring_, 1);
  [[nodiscard]] Polynomial number(const Rational& value) const { return {ring_, value}; }
};

TEST_F(Polynomials, are_sums_of_terms) {
  const Polynomial p = number(ratio(-1, 2)) * x_.power(2) * y_ + number(3);
  EXPECT_EQ(p.text(), "-1/2*x^2*y + 3");
  EXPECT_EQ((p - p).text(), "0");
  EXPECT_EQ((-x_ + y_).text(), "-x + y");
  EXPECT_EQ(p.term_count(), 2U);
  EXPECT_EQ(p.degrees(), (std::vector<unsigned long>{2, 1}));
  EXPECT_EQ((p - p).degrees(), (std::vector<unsigned long>{0, 0}));
  EXPECT_EQ(p.terms()[0].coefficient, ratio(-1, 2));
  EXPECT_EQ(p.terms()[0].exponents, (std::vector<unsigned long>{2, 1}));
  EXPECT_FALSE(p.constant());
  EXPECT_EQ(*number(ratio(2, 3)).constant(), ratio(2, 3));
  EXPECT_TRUE((p - p).is_zero());
}

TEST_F(Polynomials, have_exact_values) {
  const Polynomial p = number(ratio(-1, 2)) * x_.power(2) * y_ + number(3);
  EXPECT_EQ(p.at({ratio(2, 3), ratio(-5, 7)}), Rational(3) + ratio(1, 2) * ratio(4, 9) * ratio(5, 7));
  EXPECT_EQ((p - p).at({ratio(2, 3), ratio(-5, 7)}), Rational(0));
}

TEST_F(Polynomials, are_copied_and_moved) {
  Polynomial p = x_ + y_;
  const Polynomial copy = p;
  const Polynomial moved = std::move(p);
  EXPECT_EQ(copy, moved);
  p = copy * copy;
  EXPECT_FALSE(p == copy);
  EXPECT_EQ(p, x_ * x_ + number(2) * x_ * y_ + y_ * y_);
}

TEST_F(Polynomials, have_roots_only_if_they_are_squares) {
  const auto root = ((number(2) * x_ - y_) * (number(2) * x_ - y_)).square_root();
  ASSERT_TRUE(root);
  EXPECT_EQ(*root, number(2) * x_ - y_);
  EXPECT_FALSE((x_ * x_ + y_).square_root());
  EXPECT_FALSE((-(x_ * x_)).square_root());
}

TEST_F(Polynomials, are_divided_exactly_or_not_at_all) {
  const Polynomial p = (x_ + y_) * (x_ - number(3));
  EXPECT_EQ(Polynomial::exact_quotient(p, x_ + y_), x_ - number(3));
  EXPECT_THROW((void)Polynomial::exact_quotient(p, x_ - y_), std::domain_error);
  const Polynomial common = Polynomial::common_divisor(p, (x_ + y_) * y_);
  EXPECT_EQ(Polynomial::exact_quotient(common, x_ + y_).constant().has_value(), true);
}

TEST_F(Polynomials, have_factors_whose_product_they_are) {
  const Polynomial p = number(ratio(-3, 2)) * (number(2) * x_ - y_).power(2) * (x_ + number(1));
  const auto factors = p.factors();
  Polynomial again = number(factors.constant);
  for (const auto& [base, exponent] : factors.powers) {
    again = again * base.power(exponent);
    EXPECT_GT(base.terms().front().coefficient, Rational(0));
    for (const auto& term : base.terms()) EXPECT_EQ(term.coefficient.denominator(), 1);
  }
  EXPECT_EQ(again, p);
  EXPECT_EQ(factors.powers.size(), 2U);
}

TEST(PolynomialRings, may_be_without_parameters) {
  const auto ring = std::make_shared<const PolynomialRing>(std::vector<std::string>{});
  EXPECT_EQ((Polynomial(ring, Rational(2)) + Polynomial(ring, Rational(3))).text(), "5");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
