#include "proofs/formula/type_check.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/parser.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "tests/proofs/formula/words_about_simplices.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using words_about_simplices::vocabulary;

const Signature& signature() {
  static const Signature result{{"s", types::simplex},
                                {"k", types::integer},
                                {"m", types::integer},
                                {"xi", types::number},
                                {"mu0", types::number}};
  return result;
}

ExpressionPointer typed(std::string_view text, const Type& expected) {
  return type_checked(parse_formula(text), vocabulary(), signature(), expected);
}

std::pair<std::size_t, std::string> error_of(std::string_view text, const Type& expected = types::truth) {
  try {
    (void)typed(text, expected);
  } catch (const FormulaError& error) {
    return {error.offset(), error.what()};
  }
  return {0, "accepted"};
}

TEST(TypeCheck, integers_stay_integers_and_serve_as_numbers) {
  EXPECT_EQ(typed("k + 2*m - 1", types::integer)->type, types::integer);
  EXPECT_EQ(typed("-k", types::integer)->type, types::integer);
  EXPECT_EQ(typed("k^2", types::integer)->type, types::integer);
  EXPECT_EQ(typed("k/2", types::number)->type, types::number);
  EXPECT_EQ(typed("k^-1", types::number)->type, types::number);
  EXPECT_EQ(typed("k^m", types::number)->type, types::number);
  EXPECT_EQ(typed("k^65", types::number)->type, types::number);
  EXPECT_EQ(typed("k + xi", types::number)->type, types::number);
  EXPECT_EQ(typed("sqrt(4)", types::number)->type, types::number);
  EXPECT_EQ(typed("k", types::number)->type, types::integer);
}

TEST(TypeCheck, statements_are_made_of_comparisons_and_predicates) {
  EXPECT_EQ(typed("forall f in faces(s): is_good(f, 1) implies thickness(f) >= xi", types::truth)->type, types::truth);
  EXPECT_EQ(typed("exists i in 1..k: altitude(s, i) < 1", types::truth)->type, types::truth);
}

TEST(TypeCheck, calls_know_their_functions) {
  const auto call = typed("thickness(s)", types::number);
  ASSERT_NE(call->function, nullptr);
  EXPECT_EQ(call->function->name, "thickness");
  const auto defined = typed("constant_c(m, mu0)", types::number);
  EXPECT_EQ(defined->function, nullptr);
  ASSERT_NE(defined->definition, nullptr);
  EXPECT_EQ(defined->definition->name, "constant_c");
}

TEST(TypeCheck, exponents_are_made_of_integers_and_halves) {
  for (const char* text : {"xi^2", "xi^-1", "xi^(1/2)", "xi^(k/2)", "xi^(4*m^2 + 5*m + 21)", "xi^((k + 1)/2)",
                           "xi^-(3/2)", "xi^(k - 1)", "xi^(1/2*k)", "xi^1000000", "xi^(4/8)"}) {
    EXPECT_NO_THROW((void)typed(text, types::number)) << text;
  }
  const std::string fraction = "an exponent that is neither an integer nor half of one";
  EXPECT_EQ(error_of("xi^xi", types::number).second, "an exponent must be made of integers and halves of them");
  EXPECT_EQ(error_of("xi^sqrt(4)", types::number).second, "an exponent must be made of integers and halves of them");
  EXPECT_EQ(error_of("xi^(2/xi)", types::number).second, "an exponent must be made of integers and halves of them");
  EXPECT_EQ(error_of("xi^(1/3)", types::number).second, fraction);
  EXPECT_EQ(error_of("xi^(1/0)", types::number).second, fraction);
  EXPECT_EQ(error_of("xi^1000001", types::number).second, "an exponent beyond 1000000");
  EXPECT_EQ(error_of("2^-(10^7)", types::number).second, "an exponent beyond 1000000");
}

TEST(TypeCheck, errors_say_what_and_where) {
  const std::vector<std::pair<std::string, std::pair<std::size_t, std::string>>> cases{
      {"eta <= 1", {0, "nothing here is called eta (there are k, m, mu0, s, xi)"}},
      {"1 <= mu1", {5, "nothing here is called mu1, did you mean mu0? (there are k, m, mu0, s, xi)"}},
      {"thicknes(s) <= 1", {0, "no function is called thicknes, did you mean thickness?"}},
      {"thickness <= 1", {0, "thickness is a function: its arguments are missing"}},
      {"constant_c <= 1", {0, "constant_c is a function: its arguments are missing"}},
      {"k(m + 1) <= 1", {0, "k is a name, not a function: products are written with *"}},
      {"thickness(s, 1) <= 1", {0, "thickness expects 1 argument, not 2"}},
      {"altitude(s) <= 1", {0, "altitude expects 2 arguments, not 1"}},
      {"min(1) <= 1", {0, "min expects two or more arguments, not 1"}},
      {"constant_c(m) <= 1", {0, "constant_c expects 2 arguments, not 1"}},
      {"constant_c(xi, mu0) <= 1", {11, "constant_c expects an integer as argument 1"}},
      {"constant_c(m, s) <= 1", {14, "a simplex where a number was expected"}},
      {"thickness(xi) <= 1", {10, "thickness expects a simplex as argument 1, not a number"}},
      {"thickness(k) <= 1", {10, "thickness expects a simplex as argument 1, not an integer"}},
      {"altitude(s, xi) <= 1", {12, "altitude expects an integer as argument 2, not a number"}},
      {"altitude(s, 1/2) <= 1", {13, "altitude expects an integer as argument 2, not a number"}},
      {"thickness(faces(s)) <= 1", {10, "thickness expects a simplex as argument 1, not a set of simplex"}},
      {"s <= 1", {0, "a simplex where a number was expected"}},
      {"s = s", {0, "a simplex where a number was expected"}},
      {"thickness(s)", {0, "a number where a statement was expected"}},
      {"k", {0, "an integer where a statement was expected"}},
      {"not k", {4, "an integer where a statement was expected"}},
      {"faces(s)", {0, "a set of simplex where a statement was expected"}},
      {"(1 < 2) < 3", {3, "a statement where a number was expected"}},
      {"1 < (2 < 3)", {7, "a statement where a number was expected"}},
      {"abs(1 < 2) < 3", {6, "abs expects a number as argument 1, not a statement"}},
      {"forall i in k: i < 1",
       {12,
        "an integer where a set was expected: a quantifier runs through a set such as "
        "faces(s) or 1..k"}},
      {"forall i in 1..xi: i < 1", {15, "range expects an integer as argument 2, not a number"}},
      {"forall k in 1..2: k < 1", {0, "the variable k is already something else"}},
      {"forall i in 1..2, i in 1..2: i < 1", {0, "the variable i is already something else"}},
      {"forall sqrt in 1..2: sqrt < 1", {0, "the variable sqrt is called like a function"}},
      {"(forall i in 1..2: i < 3) and i < 3", {30, "nothing here is called i (there are k, m, mu0, s, xi)"}},
      {"forall i in 1..2: i", {18, "an integer where a statement was expected"}},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(error_of(text), expected) << text;
}

TEST(TypeCheck, a_variable_ends_with_its_quantifier) {
  EXPECT_NO_THROW((void)typed("(forall i in 1..2: i < 3) and (forall i in 1..2: i < 3)", types::truth));
}

TEST(TypeCheck, without_names_none_are_listed) {
  try {
    (void)type_checked(parse_formula("x < 1"), vocabulary(), {}, types::truth);
    FAIL();
  } catch (const FormulaError& error) {
    EXPECT_STREQ(error.what(), "nothing here is called x");
  }
}

TEST(FreeNames, are_those_that_no_quantifier_binds) {
  const auto names = [](std::string_view text) { return free_names(*parse_formula(text)); };
  EXPECT_EQ(names("k + m*k"), (std::vector<std::string>{"k", "m"}));
  EXPECT_EQ(names("forall i in 1..k: f(i, s) < xi"), (std::vector<std::string>{"k", "s", "xi"}));
  // The set of a quantifier is outside of its reach.
  EXPECT_EQ(names("forall i in 1..i: p"), (std::vector<std::string>{"i", "p"}));
  EXPECT_EQ(names("(forall i in 1..2: i < 1) and i < 2"), (std::vector<std::string>{"i"}));
  EXPECT_EQ(names("1 < 2"), std::vector<std::string>{});
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
