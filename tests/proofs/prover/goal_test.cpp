#include "proofs/prover/goal.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/formula_text.hpp"
#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::step;

std::vector<std::string> goals(const std::string& lines) {
  const Step of = step("forall = { x = '[0, 1]', y = '[0, 1]' }\n" + lines);
  std::vector<ExpressionPointer> hypotheses;
  for (const Statement& hypothesis : of.hypotheses) hypotheses.push_back(hypothesis.formula);
  std::vector<std::string> result;
  for (const auto& goal : goal_statements(hypotheses, of.claim.formula)) result.push_back(formula_text(*goal));
  return result;
}

Goal goal(const std::string& lines) {
  const Step of = step(lines);
  return make_goal(of.claim.formula, of.parameters);
}

using Texts = std::vector<std::string>;

TEST(Goals, are_the_parts_of_conjunctions) {
  EXPECT_EQ(goals("claim = '0 <= x < 2 and y >= 0'"), (Texts{"0 <= x", "x < 2", "y >= 0"}));
  EXPECT_EQ(
      goals("given = ['x < y']\nclaim = 'x < 1 and (y > 1/2 implies x < 2 and y < 2)'"),
      (Texts{"x < y implies x < 1", "x < y implies y > 1/2 implies x < 2", "x < y implies y > 1/2 implies y < 2"}));
  EXPECT_EQ(goals("claim = 'x < 1 or y < 1 and x > 0'"), (Texts{"x < 1 or y < 1 and x > 0"}));
}

TEST(Goals, have_no_extremes_beside_comparisons) {
  EXPECT_EQ(goals("claim = 'max(x, y) <= 1'"), (Texts{"x <= 1", "y <= 1"}));
  EXPECT_EQ(goals("claim = '1 >= min(x, y)'"), (Texts{"1 >= x or 1 >= y"}));
  EXPECT_EQ(goals("claim = 'abs(x - y) < 2'"), (Texts{"x - y < 2", "-(x - y) < 2"}));
  EXPECT_EQ(goals("claim = 'max(x, 1/y) >= 1'"), (Texts{"1/y = 1/y", "x >= 1 or 1/y >= 1"}));
  EXPECT_EQ(goals("claim = 'max(x, y) = 1'"), (Texts{"max(x, y) = 1"}));
}

TEST(Goals, know_their_comparisons_as_products_of_polynomials) {
  const Goal of = goal("forall = { x = '(0, 1]' }\nclaim = '1/(1 + x) >= 1/(1 + x)^2'");
  EXPECT_EQ(of.method(), "polynomial");
  ASSERT_EQ(of.atoms.size(), 1U);
  const PolynomialForm& form = *of.atoms[0].polynomial;
  // 1/(1 + x) − 1/(1 + x)² = x/(1 + x)²
  EXPECT_EQ(form.constant, Rational(1));
  long exponent_of_x = 0;
  long exponent_of_sum = 0;
  for (const auto& power : form.powers) {
    (of.factors[power.factor].text() == "x" ? exponent_of_x : exponent_of_sum) = power.exponent;
  }
  EXPECT_EQ(exponent_of_x, 1);
  EXPECT_EQ(exponent_of_sum, -2);
  ASSERT_EQ(form.divisors.size(), 1U);
  EXPECT_EQ(of.factors[form.divisors[0]].text(), "x + 1");
}

TEST(Goals, square_parameters_under_roots) {
  const Goal of = goal("forall = { k = 'integer [1, infinity)', x = '[0, 1]' }\nclaim = 'sqrt(k) >= x'");
  EXPECT_EQ(of.is_squared, (std::vector<bool>{true, false}));
  EXPECT_EQ(of.method(), "polynomial");
  EXPECT_EQ(goal("forall = { x = '[-1, 1]' }\nclaim = 'sqrt(x + 1) >= 0'").method(), "interval");
  EXPECT_EQ(goal("forall = { x = '[-1, 0]' }\nclaim = 'sqrt(x) >= 0'").method(), "interval") << "x may be negative";
  EXPECT_EQ(goal("forall = { k = 'integer [1, infinity)' }\nclaim = 'log2(k) >= 0 or k > 2'").method(), "mixed");
}

TEST(Goals, join_verdicts_as_kleene_does) {
  const Goal of = goal("forall = { x = '[0, 1]' }\nclaim = 'not x < 1 or x < 2 and x > 0'");
  using enum Verdict;
  EXPECT_EQ(of.value({undecided, proved, proved}), proved);
  EXPECT_EQ(of.value({refuted, undecided, refuted}), proved);
  EXPECT_EQ(of.value({proved, undecided, refuted}), refuted);
  EXPECT_EQ(of.value({proved, undecided, proved}), undecided);
}

TEST(Goals, compare_by_signs) {
  EXPECT_EQ(verdict_of(Operation::less, Sign::negative), Verdict::proved);
  EXPECT_EQ(verdict_of(Operation::less, Sign::nonpositive), Verdict::undecided);
  EXPECT_EQ(verdict_of(Operation::less, Sign::nonnegative), Verdict::refuted);
  EXPECT_EQ(verdict_of(Operation::less_equal, Sign::nonpositive), Verdict::proved);
  EXPECT_EQ(verdict_of(Operation::less_equal, Sign::nonnegative), Verdict::undecided);
  EXPECT_EQ(verdict_of(Operation::greater, Sign::zero), Verdict::refuted);
  EXPECT_EQ(verdict_of(Operation::greater_equal, Sign::zero), Verdict::proved);
  EXPECT_EQ(verdict_of(Operation::equal, Sign::zero), Verdict::proved);
  EXPECT_EQ(verdict_of(Operation::equal, Sign::positive), Verdict::refuted);
  EXPECT_EQ(verdict_of(Operation::equal, Sign::nonnegative), Verdict::undecided);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
