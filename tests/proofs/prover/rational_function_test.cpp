#include "proofs/prover/rational_function.hpp"

#include <gtest/gtest.h>

#include "proofs/formula/type_check.hpp"
#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

const RingPointer ring = std::make_shared<const PolynomialRing>(std::vector<std::string>{"k", "x"});

ExpressionPointer term(const std::string& text) {
  return type_checked(parse_formula(text), test::numbers(), {{"k", types::integer}, {"x", types::number}},
                      types::number);
}

/// k is at least 1, x between 0 and 1.
Sign sign_of(const Polynomial& p) {
  const UnitMap up{Rational(1), std::nullopt};
  const UnitMap unit{Rational(0), Rational(1)};
  return p.is_zero() ? Sign::zero : BernsteinTensor(p, {up, unit}, 1000).sign({{false, true}, {}});
}

std::string read(const std::string& text, const std::vector<bool>& squared = {false, false}) {
  RationalFunctionReader reader(ring, squared, sign_of);
  const auto expression = term(text);
  const auto result = reader.read(*expression);
  return result ? result->numerator.text() + " over " + result->denominator.text() : "nothing";
}

TEST(RationalFunctions, are_reduced) {
  EXPECT_EQ(read("(x^2 - 1)/(x - 1)"), "x + 1 over 1");
  EXPECT_EQ(read("1/x - 1/k"), "k - x over k*x");
  EXPECT_EQ(read("x^-2"), "1 over x^2");
  EXPECT_EQ(read("-(x - 1)^3/2"), "-1/2*x^3 + 3/2*x^2 - 3/2*x + 1/2 over 1");
}

TEST(RationalFunctions, remember_what_they_divide_by) {
  RationalFunctionReader reader(ring, {false, false}, sign_of);
  const auto expression = term("(x^2 - 1)/(x - 1) + 1/2 + k^-1");
  ASSERT_TRUE(reader.read(*expression));
  ASSERT_EQ(reader.divisors().size(), 2U);
  EXPECT_EQ(reader.divisors()[0].text(), "x - 1");
  EXPECT_EQ(reader.divisors()[1].text(), "k");
  reader.forget_divisors();
  EXPECT_TRUE(reader.divisors().empty());
}

TEST(RationalFunctions, ask_for_squares_and_take_their_roots) {
  RationalFunctionReader reader(ring, {false, false}, sign_of);
  const auto expression = term("k^(3/2)*x");
  EXPECT_FALSE(reader.read(*expression));
  EXPECT_EQ(reader.wanted_squares(), (std::set<std::size_t>{0}));
  EXPECT_EQ(read("k^(3/2)*x", {true, false}), "k^3*x over 1");
  EXPECT_EQ(read("sqrt(4*k/9)", {true, false}), "2/3*k over 1");
  EXPECT_EQ(read("sqrt(2*k)", {true, false}), "nothing");
  EXPECT_EQ(read("sqrt(k + x)"), "nothing");
}

TEST(RationalFunctions, of_a_square_have_the_root_that_is_not_negative) {
  EXPECT_EQ(read("sqrt((k - 1)^2)"), "k - 1 over 1");
  EXPECT_EQ(read("sqrt((x - 1)^2)"), "-x + 1 over 1");
  EXPECT_EQ(read("sqrt((x - k/2)^2)"), "nothing");
  EXPECT_EQ(read("abs(x - 2)"), "-x + 2 over 1");
  EXPECT_EQ(read("abs(x - 1/2)"), "nothing");
  EXPECT_EQ(read("max(x, k) + min(x, k)"), "k + x over 1");
}

TEST(RationalFunctions, are_not_what_has_another_form_or_no_moderate_size) {
  EXPECT_EQ(read("log2(k)"), "nothing");
  EXPECT_EQ(read("2^k"), "nothing");
  EXPECT_EQ(read("1/(x - x)"), "nothing");
  EXPECT_EQ(read("(1 + x + k)^1000"), "nothing");
  EXPECT_NE(read("x/2^1000"), "nothing");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
