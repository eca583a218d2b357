#include "proofs/formula/substitution.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/formula_text.hpp"
#include "proofs/formula/type_check.hpp"
#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;

ExpressionPointer typed(const std::string& text, const Type& type = types::truth) {
  const Signature signature{{"x", types::number}, {"y", types::number}, {"k", types::integer}};
  return type_checked(parse_formula(text), full_vocabulary(), signature, type);
}

TEST(Substitution, puts_terms_in_the_place_of_names) {
  const auto term = typed("x + y", types::number);
  EXPECT_EQ(formula_text(*replaced(typed("x*x < y"), {{"x", term}})), "(x + y)*(x + y) < y");
  EXPECT_EQ(formula_text(*replaced(typed("-x^2 < y"), {{"x", term}, {"y", term}})), "-(x + y)^2 < x + y");
}

TEST(Substitution, leaves_alone_what_is_not_named) {
  const auto statement = typed("x < y");
  EXPECT_EQ(replaced(statement, {{"k", typed("2", types::number)}}), statement);
}

TEST(Substitution, leaves_alone_what_a_quantifier_binds) {
  const auto statement = typed("forall p in 1 .. k: p < x and exists q in 1 .. p: q < x");
  EXPECT_EQ(formula_text(*replaced(statement, {{"p", typed("7", types::number)}, {"x", typed("y", types::number)}})),
            "forall p in 1 .. k: p < y and (exists q in 1 .. p: q < y)");
}

TEST(Substitution, bodies_take_the_place_of_definitions) {
  EXPECT_EQ(formula_text(*without_definitions(typed("hoop_bound(x + y, x) > constant_c(k, y)"))),
            "2^13*(x + y)/x^3 > k^(3/2)*(2/y)^(4*k^2 + 5*k + 21)");
  EXPECT_EQ(formula_text(*without_definitions(typed("hoop_bound(hoop_bound(x, y), y) > 0"))),
            "2^13*(2^13*x/y^3)/y^3 > 0");
  const auto statement = typed("sqrt(x) < y");
  EXPECT_EQ(without_definitions(statement), statement);
}

TEST(Substitution, numbers_are_written_as_the_parser_reads_them) {
  for (const Rational& value : {Rational(0), Rational(7), Rational(-7), ratio(3, 4), ratio(-3, 4)}) {
    const auto term = number_expression(value);
    const Bindings nothing;
    Scene scene(nothing);
    EXPECT_EQ(exact_value(*typed(formula_text(*term), types::number), scene), value);
    EXPECT_TRUE(is_same_formula(*parse_formula(formula_text(*term)), *term));
  }
}

TEST(Substitution, a_base_is_taken_off_both_sides_of_all_comparisons) {
  const auto base = typed("2*y", types::number);
  EXPECT_EQ(formula_text(*less_base(typed("x <= y and (k < 1 implies x > sqrt(y))"), base)),
            "x - 2*y <= y - 2*y and (k - 2*y < 1 - 2*y implies x - 2*y > sqrt(y) - 2*y)");
  EXPECT_EQ(formula_text(*less_base(typed("forall p in 1 .. k: p < y"), base)),
            "forall p in 1 .. k: p - 2*y < y - 2*y");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
