#include "proofs/formula/step.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/formula_text.hpp"
#include "kernel/formula/parser.hpp"
#include "proofs/formula/type_check.hpp"
#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;

std::string error_of(const std::string& text) {
  try {
    (void)parse_step_range(text);
  } catch (const FormulaError& error) {
    return std::to_string(error.offset()) + ": " + error.what();
  }
  return "accepted";
}

TEST(StepRange, is_read_and_written) {
  for (const char* text : {"(0, 1/4]", "[1, infinity)", "integer [1, infinity)", "(-infinity, 0]",
                           "(-infinity, infinity)", "[-3/2, -1]", "integer (1/2, 3]", "[2, 2]"}) {
    EXPECT_EQ(step_range_text(parse_step_range(text)), text);
  }
  const StepRange range = parse_step_range("integer [1,infinity)");
  EXPECT_TRUE(range.is_integer && range.has_lower && !range.has_upper && !range.upper);
  EXPECT_EQ(*range.lower, Rational(1));
}

TEST(StepRange, knows_what_it_contains) {
  const StepRange range = parse_step_range("(0, 1]");
  EXPECT_TRUE(range.contains(Rational(1)) && range.contains(ratio(1, 1000)));
  EXPECT_FALSE(range.contains(Rational(0)) || range.contains(ratio(1001, 1000)));
  const StepRange integers = parse_step_range("integer [1, infinity)");
  EXPECT_TRUE(integers.contains(Rational(1)) && integers.contains(Rational(1000000)));
  EXPECT_FALSE(integers.contains(Rational(0)) || integers.contains(ratio(3, 2)));
}

TEST(StepRange, errors_say_where) {
  EXPECT_EQ(error_of("[1, infinity]"), "12: infinity is not a number: write infinity)");
  EXPECT_EQ(error_of("[-infinity, 1]"), "0: infinity is not a number: write (-infinity");
  EXPECT_EQ(error_of("[infinity, 1]"), "1: an empty interval");
  EXPECT_EQ(error_of("(1, -infinity)"), "4: an empty interval");
  EXPECT_EQ(error_of("(1, 1]"), "0: an empty interval");
  EXPECT_EQ(error_of("integer (1, 2)"), "8: an empty interval");
  EXPECT_EQ(error_of("integer [2, 1]"), "8: an empty interval");
  EXPECT_EQ(error_of("integers [1, 2]"),
            "0: 'integers' where an interval such as (0, 1] or integer [1, infinity) was expected");
  EXPECT_EQ(error_of("(0, 1/0]"), "6: a denominator of 0");
  EXPECT_EQ(error_of("(0 1]"), "3: '1' where a comma between the ends was expected");
  EXPECT_EQ(error_of("(0, 1"), "5: the end where the end of the interval, ) or ] was expected");
  EXPECT_EQ(error_of("(0, 1] 2"), "7: '2' where the end was expected");
  EXPECT_EQ(error_of("(0, x]"), "4: 'x' where a number or infinity was expected");
}

TEST(Steps, statuses_have_names) {
  EXPECT_EQ(name_of(ClaimStatus::paper), "paper");
  EXPECT_EQ(name_of(ClaimStatus::mended), "mended");
  EXPECT_EQ(name_of(ClaimStatus::sharper), "sharper");
  EXPECT_EQ(name_of(ClaimStatus::user), "user");
}

TEST(Steps, are_expanded_to_their_parameters) {
  const auto typed = [](const std::string& text, const Signature& signature, const Type& type) {
    return type_checked(parse_formula(text), full_vocabulary(), signature, type);
  };
  Step step;
  step.parameters["m"] = parse_step_range("integer [1, infinity)");
  step.parameters["x"] = parse_step_range("(0, 1]");
  step.constants["c"] = ratio(-4, 5);
  const Signature signature{{"m", types::integer}, {"x", types::number}, {"c", types::number}, {"a", types::number}};
  step.abbreviations.push_back({"a", "", typed("c*x", signature, types::number)});
  const auto claim = typed("a + hoop_bound_tilde(m, a, x) > c", signature, types::truth);
  EXPECT_EQ(formula_text(*expanded(step, claim)), "-(4/5)*x + 2^16*m^(3/2)*(-(4/5)*x)/x^3 > -(4/5)");
  EXPECT_EQ(formula_text(*expanded(step, {{"c", Rational(2)}}, claim)), "2*x + 2^16*m^(3/2)*(2*x)/x^3 > 2");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
