#include "kernel/formula/plain_formula.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/formula_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

const std::vector<std::string> variables{"x", "y", "z_1"};

std::string canonical(std::string_view text) { return canonical_text(*parse_plain_formula(text, variables)); }

std::pair<std::size_t, std::string> error_of(std::string_view text) {
  try {
    (void)parse_plain_formula(text, variables);
  } catch (const FormulaError& error) {
    return {error.offset(), error.what()};
  }
  return {0, "accepted"};
}

TEST(PlainFormula, has_one_text) {
  EXPECT_EQ(canonical("(x ^ 2 + y^2 + z_1^2 + 3)^2 - 16 * ( x^2 + y^2 )"), "(x^2+y^2+z_1^2+3)^2-16*(x^2+y^2)");
  EXPECT_EQ(canonical("- x ^ 2 * - y - (x - y)"), "-x^2*-y-(x-y)");
  EXPECT_EQ(canonical("(-x)^2 - -(y + 007) / (2 * x)"), "(-x)^2--(y+7)/(2*x)");
  EXPECT_EQ(canonical("sqrt ( exp( x ) + sin(y ) * cos(1/2) )"), "sqrt(exp(x)+sin(y)*cos(1/2))");
  EXPECT_EQ(canonical("((x^2))^(3)"), "(x^2)^3");
}

TEST(PlainFormula, reads_its_own_text_as_the_same) {
  for (const std::string text : {"-x^2*-y-(x-y)", "x-(y-(z_1-1))", "x/y/(z_1/2)", "--x", "(-x)^3", "sqrt(x*-y)"}) {
    EXPECT_EQ(canonical(text), text);
    EXPECT_TRUE(
        is_same_formula(*parse_plain_formula(text, variables), *parse_plain_formula(canonical(text), variables)));
  }
  EXPECT_NE(canonical("x-(y-1)"), canonical("x-y-1"));
}

TEST(PlainFormula, refuses_with_the_place) {
  using Error = std::pair<std::size_t, std::string>;
  EXPECT_EQ(error_of("x + w").first, 4);
  EXPECT_EQ(error_of("x = 0"), (Error{2, "a comparison where a real function was expected: for a = b write a - b"}));
  EXPECT_EQ(error_of("x and y"), (Error{2, "a statement where a real function was expected"}));
  EXPECT_EQ(error_of("x * (not y)").first, 5);
  EXPECT_EQ(error_of("forall v in 0 .. 1: x").second, "a statement where a real function was expected");
  EXPECT_EQ(error_of("x^y"), (Error{2, "an exponent is a whole number from 0 to 100"}));
  EXPECT_EQ(error_of("x^(1/2)").first, 4);
  EXPECT_EQ(error_of("x^-1").first, 2);
  EXPECT_EQ(error_of("x^2^3").first, 3);
  EXPECT_EQ(error_of("x^101").first, 2);
  EXPECT_EQ(error_of("x + tan(y)").first, 4);
  EXPECT_EQ(error_of("x + sin"), (Error{4, "sin is a function: write sin(…)"}));
  EXPECT_EQ(error_of("sin(x, y)"), (Error{0, "sin takes one argument"}));
  EXPECT_EQ(error_of("x + * y").first, 4);
  EXPECT_EQ(error_of("x + 1.5").first, 5);
  EXPECT_EQ(error_of("").first, 0);
  EXPECT_NE(error_of("").second, "accepted");
  // The twins that are read.
  EXPECT_EQ(error_of("x^100").second, "accepted");
  EXPECT_EQ(error_of("(x^2)^3").second, "accepted");
}

TEST(PlainFormula, knows_what_a_variable_may_be_called) {
  for (const std::string_view name : {"x", "x1", "z_1", "sine", "abcdefghijklmnop"})
    EXPECT_TRUE(is_name_of_variable(name));
  for (const std::string_view name :
       {"", "X", "1x", "_x", "sin", "exp", "sqrt", "cos", "in", "and", "abcdefghijklmnopq", "x-y", "é"})
    EXPECT_FALSE(is_name_of_variable(name)) << name;
}

TEST(PlainFormula, has_absolute_values_only_for_who_asks) {
  const std::vector<std::string> names{"u", "abs"};
  EXPECT_THROW((void)parse_plain_formula("abs(u)", names), FormulaError);
  const auto formula = parse_plain_formula("u - 2*abs(u - abs)", names, AbsoluteValues::allowed);
  EXPECT_TRUE(has_absolute_values(*formula));
  EXPECT_EQ(canonical_text(*formula), "u-2*abs(u-abs)");
  EXPECT_FALSE(has_absolute_values(*parse_plain_formula("u - abs", names, AbsoluteValues::allowed)));
  EXPECT_THROW((void)parse_plain_formula("abs(u, abs)", names, AbsoluteValues::allowed), FormulaError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
