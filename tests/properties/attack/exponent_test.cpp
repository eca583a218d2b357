#include "properties/attack/exponent.hpp"

#include <gtest/gtest.h>

#include "proofs/formula/arithmetic_vocabulary.hpp"
#include "proofs/formula/type_check.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::optional<Rational> exponent(const std::string& quantity, const std::string& term) {
  Vocabulary vocabulary;
  add_arithmetic(vocabulary);
  const Signature signature{{"x", types::number}, {"y", types::number}, {"k", types::integer}, {"m", types::integer}};
  const auto read = [&](const std::string& text) {
    return type_checked(parse_formula(text), vocabulary, signature, types::number);
  };
  return exponent_of(*read(quantity), *read(term), {{"k", 3L}, {"m", 4L}});
}

const Rational half = Rational(1) / Rational(2);

TEST(Exponent, products_add_and_quotients_subtract) {
  EXPECT_EQ(exponent("x", "x"), Rational(1));
  EXPECT_EQ(exponent("x", "y"), Rational(0));
  EXPECT_EQ(exponent("x", "16*k^(3/2)*y*x/x^3"), Rational(-2));
  EXPECT_EQ(exponent("x", "-(x*y)*x"), Rational(2));
  EXPECT_EQ(exponent("x", "1/x"), Rational(-1));
}

TEST(Exponent, powers_and_roots_multiply) {
  EXPECT_EQ(exponent("x", "x^(2*k + 1)"), Rational(7));
  EXPECT_EQ(exponent("x", "y/x^(2*k)"), Rational(-6));
  EXPECT_EQ(exponent("x", "sqrt(42*k^2*y/x^3)"), Rational(-3) * half);
  EXPECT_EQ(exponent("k", "16*k^(3/2)*x"), Rational(3) * half);
  EXPECT_EQ(exponent("x", "(x^2*y)^(1/2)"), Rational(1));
}

TEST(Exponent, the_quantity_may_be_a_term) {
  EXPECT_EQ(exponent("x*y", "k/(x*y)^2"), Rational(-2));
  EXPECT_EQ(exponent("x + y", "k*(x + y)"), Rational(1));
}

TEST(Exponent, a_sum_has_one_only_if_its_terms_have_the_same) {
  EXPECT_EQ(exponent("x", "2*x*y - x/y"), Rational(1));
  EXPECT_EQ(exponent("x", "x + y"), std::nullopt);
  EXPECT_EQ(exponent("x", "y*(x + x^2)"), std::nullopt);
  EXPECT_EQ(exponent("y", "x*(1 + x)*y^2"), Rational(2));
}

TEST(Exponent, what_is_no_power_has_none) {
  EXPECT_EQ(exponent("x", "max(x, y)"), std::nullopt);
  EXPECT_EQ(exponent("x", "abs(x)"), std::nullopt);
  EXPECT_EQ(exponent("k", "x^(2*k)"), std::nullopt);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
