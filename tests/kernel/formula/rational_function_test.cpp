#include "kernel/formula/rational_function.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/plain_formula.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const RingPointer ring = std::make_shared<const PolynomialRing>(std::vector<std::string>{"x0", "x1"});
const std::vector<std::string> variables{"u", "v"};

std::optional<RationalFunction> read(const std::string& text) {
  return rational_function_of(*parse_plain_formula(text, variables), variables, ring);
}

std::string text_of(const std::string& text) {
  const auto found = read(text);
  return found ? found->numerator.text() + " over " + found->denominator.text() : "nothing";
}

TEST(RationalFunction, is_read_by_the_places_of_the_variables_and_reduced) {
  EXPECT_EQ(text_of("(u^2 - 1)/(u - 1)"), "x0 + 1 over 1");
  EXPECT_EQ(text_of("1/u - 1/v"), "-x0 + x1 over x0*x1");
  EXPECT_EQ(text_of("-(2*v)^2/3"), "-4/3*x1^2 over 1");
  EXPECT_EQ(text_of("u - u"), "0 over 1");
}

TEST(RationalFunction, is_not_what_divides_by_zero_names_a_function_or_is_too_large) {
  EXPECT_EQ(text_of("1/(u - u)"), "nothing");
  EXPECT_EQ(text_of("sqrt(u)"), "nothing");
  EXPECT_EQ(text_of("(u + v + 1)^100"), "nothing");
  EXPECT_NE(text_of("(u + v)^100"), "nothing");
  EXPECT_EQ(text_of("((u + v)^100)^100"), "nothing");
}

TEST(RationalFunction, is_equal_to_another_however_both_are_written) {
  EXPECT_TRUE(*read("u/v - 1") == *read("(2*u - 2*v)/(2*v)"));
  EXPECT_FALSE(*read("u/v - 1") == *read("(2*u - 2*v)/(2*v + 1)"));
  EXPECT_FALSE(*read("u/v") == *read("-u/v"));
}

TEST(RationalFunction, is_composed_as_its_values_are) {
  // The two charts of the plane sphere: x/|x|² twice is the identity.
  const std::vector<RationalFunction> inversion{*read("u/(u^2 + v^2)"), *read("v/(u^2 + v^2)")};
  EXPECT_TRUE(*composed(inversion[0], inversion) == *read("u"));
  EXPECT_TRUE(*composed(inversion[1], inversion) == *read("v"));
  EXPECT_FALSE(*composed(inversion[1], inversion) == *read("u"));

  const auto g = *read("(u^2 - 3*v)/(1 + u*v)");
  const std::vector<RationalFunction> f{*read("(u + v)/(u - 2)"), *read("v^2/5")};
  const std::vector<Rational> x{ratio(3, 7), ratio(-2, 9)};
  const std::vector<Rational> between{*value_at(f[0], x), *value_at(f[1], x)};
  EXPECT_EQ(*value_at(*composed(g, f), x), *value_at(g, between));
  EXPECT_NE(*value_at(*composed(g, f), x), *value_at(g, x));
}

TEST(RationalFunction, has_no_composition_where_that_would_divide_by_zero_everywhere) {
  EXPECT_FALSE(composed(*read("1/(u - v)"), {*read("u"), *read("u")}));
  EXPECT_TRUE(composed(*read("1/(u - v)"), {*read("u"), *read("v")}));
}

TEST(RationalFunction, has_no_value_at_a_pole) {
  EXPECT_FALSE(value_at(*read("1/(u - v)"), {ratio(1, 3), ratio(1, 3)}));
  EXPECT_EQ(value_at(*read("1/(u - v)"), {ratio(1, 3), ratio(1, 6)}), Rational(6));
}

TEST(RationalFunction, that_is_too_large_is_not_worked_with) {
  const auto large = *read("(u + v)^100");
  EXPECT_THROW((void)composed(*read("u^100"), {large, large}), std::length_error);
  EXPECT_TRUE(is_moderate(large));
  EXPECT_FALSE(has_moderate_power(large.numerator, 100));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
