#include "kernel/formula/formula_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "kernel/formula/parser.hpp"
#include "tests/proofs/formula/random_formulas.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::string printed(std::string_view text) { return formula_text(*parse_formula(text)); }

TEST(FormulaText, has_parentheses_only_where_they_are_needed) {
  for (const char* text : {"a + b*c",
                           "(a + b)*c",
                           "a - (b - c)",
                           "a - b - c",
                           "a/(b/c)",
                           "-a^2",
                           "(-a)^2",
                           "a^b^c",
                           "(a^b)^c",
                           "a^-b",
                           "a^(b + c)",
                           "a*-b",
                           "-(a*b)",
                           "-a*b",
                           "--a",
                           "not a < b",
                           "not (p and q)",
                           "p and q or r",
                           "p and (q or r)",
                           "p implies q implies r",
                           "(p implies q) implies r",
                           "a < b and b <= c",
                           "(a < b) < c",
                           "forall i in 1 .. k: p and q",
                           "(forall i in 1 .. k: p) and q",
                           "p implies exists f in faces(s): q",
                           "f(a < b, c)",
                           "f()"}) {
    EXPECT_EQ(printed(text), text);
  }
  EXPECT_EQ(printed("((a))+(b*c)"), "a + b*c");
  EXPECT_EQ(printed("0 < a <= 1"), "0 < a and a <= 1");
  EXPECT_EQ(printed("forall i in range(1, k), j in 1..i: p"), "forall i in 1 .. k: forall j in 1 .. i: p");
}

RC_GTEST_PROP(FormulaText, what_is_printed_is_read_as_the_same_tree, ()) {
  const auto tree = formulas::any_tree(*rc::gen::inRange(0, 6));
  const std::string text = formula_text(*tree);
  RC_LOG(text);
  RC_ASSERT(is_same_formula(*parse_formula(text), *tree));
}

TEST(FormulaText, trees_differ_by_operation_name_value_and_parts) {
  const auto same = [](std::string_view a, std::string_view b) {
    return is_same_formula(*parse_formula(a), *parse_formula(b));
  };
  EXPECT_TRUE(same("a+b", " a  +  (b)"));
  EXPECT_FALSE(same("a+b", "a-b"));
  EXPECT_FALSE(same("a+b", "b+a"));
  EXPECT_FALSE(same("1", "2"));
  EXPECT_FALSE(same("f(a)", "f(a, a)"));
  EXPECT_FALSE(same("f(a)", "g(a)"));
  EXPECT_FALSE(same("forall i in f(a): i < 1", "forall j in f(a): i < 1"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
