#include "proofs/tables/hole.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/parser.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::optional<Rational> in(const std::string& formula, const std::string& pattern) {
  return constant_in(*parse_formula(formula), *parse_formula(pattern));
}

Rational fraction(long a, long b) { return Rational(a) / Rational(b); }

TEST(Hole, is_filled_by_the_number_that_stands_there) {
  EXPECT_EQ(in("a <= 42*b", "a <= C*b"), Rational(42));
  EXPECT_EQ(in("a <= 98/25*k^2*b", "a <= C*k^2*b"), fraction(98, 25));
  EXPECT_EQ(in("f(x) >= (1 - 2*eta^2)/g(y)", "f(x) >= (1 - C*eta^2)/g(y)"), Rational(2));
  EXPECT_EQ(in("forall p in v: d(p) < 99/100*5/2*(1 + x)*e", "forall p in v: d(p) < C*(1 + x)*e"), fraction(99, 40));
  EXPECT_EQ(in("is_good(s, 101/100*g)", "is_good(s, C*g)"), fraction(101, 100));
  EXPECT_EQ(in("a <= (1 - 1/2^20)*b", "a <= C*b"), Rational(1) - Rational::power_of_two(-20));
}

TEST(Hole, is_one_where_nothing_stands) {
  EXPECT_EQ(in("a <= sqrt(k)*b", "a <= C*sqrt(k)*b"), Rational(1));
  EXPECT_EQ(in("a >= 1 - eta^2", "a >= 1 - C*eta^2"), Rational(1));
}

TEST(Hole, may_be_in_a_denominator_with_a_name) {
  EXPECT_EQ(in("a < (21/(2*mu))^m", "a < (C/mu)^m"), fraction(21, 2));
  EXPECT_EQ(in("a >= 2/(5*sqrt(k))*g", "a >= C/sqrt(k)*g"), fraction(2, 5));
}

TEST(Hole, is_what_all_numbers_of_a_product_make) {
  EXPECT_EQ(in("r <= l/(2*t)", "r <= C*l/t"), fraction(1, 2));
  EXPECT_EQ(in("r <= (1 - 1/4)*l/(2*t)", "r <= C*l/t"), fraction(3, 8));
  EXPECT_EQ(in("r <= 2*(a + 12*k*x)*e", "r <= 2*(a + C*k*x)*e"), Rational(12));
  EXPECT_FALSE(in("r <= 9/5*(a + 12*k*x)*e", "r <= 2*(a + C*k*x)*e"));
  EXPECT_EQ(in("x <= (t/4)^2", "x <= (C*t)^2"), fraction(1, 4));
}

TEST(Hole, is_not_found_in_another_formula) {
  EXPECT_FALSE(in("a <= 42*b", "a >= C*b"));
  EXPECT_FALSE(in("a <= 42*b", "a <= C*c"));
  EXPECT_FALSE(in("a <= 42*b*c", "a <= C*b"));
  EXPECT_FALSE(in("a <= k*b", "a <= C*b"));
  EXPECT_FALSE(in("x <= 42*b", "a <= C*b"));
  EXPECT_FALSE(in("f(a) <= 42", "f(a, b) <= C"));
}

TEST(Hole, takes_expressions_without_names_only) {
  const auto value = [](const std::string& text) { return constant_value(*parse_formula(text)); };
  EXPECT_EQ(value("-(3 - 1/2)*2^3"), Rational(-20));
  EXPECT_EQ(value("2^(-1)"), fraction(1, 2));
  EXPECT_FALSE(value("x"));
  EXPECT_FALSE(value("1/0"));
  EXPECT_FALSE(value("0^(-1)"));
  EXPECT_FALSE(value("2^(1/2)"));
  EXPECT_FALSE(value("2^100000"));
  EXPECT_FALSE(value("sqrt(4)"));
  EXPECT_FALSE(value("1 < 2"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
