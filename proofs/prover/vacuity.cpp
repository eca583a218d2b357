#include "proofs/prover/vacuity.hpp"

#include <set>

#include "kernel/formula/formula_text.hpp"
#include "proofs/formula/substitution.hpp"
#include "proofs/formula/type_check.hpp"

namespace delcert {

namespace {

/// 1 <= 0
ExpressionPointer contradiction() {
  auto result = std::make_shared<Expression>();
  result->operation = Operation::less_equal;
  result->children = {number_expression(Rational(1)), number_expression(Rational(0))};
  result->type = types::truth;
  return result;
}

/// What a goal supposes: h₁, h₂ of `h₁ implies (h₂ implies c)`.
std::vector<Statement> premises_of(ExpressionPointer goal) {
  std::vector<Statement> result;
  while (goal->operation == Operation::implication) {
    result.push_back(
        {"premise-" + std::to_string(result.size() + 1), formula_text(*goal->children[0]), goal->children[0]});
    goal = goal->children[1];
  }
  return result;
}

std::string text_of_premises(const std::vector<Statement>& premises) {
  std::string result;
  for (const Statement& premise : premises) result += (result.empty() ? "" : " and ") + premise.text;
  return result;
}

}  // namespace

Vacuity vacuity_of(const Step& step, const SearchLimits& limits) {
  std::vector<ExpressionPointer> hypotheses;
  for (const Statement& hypothesis : step.hypotheses) hypotheses.push_back(expanded(step, hypothesis.formula));
  Vacuity result;
  result.verdict = Verdict::refuted;
  std::set<std::string> seen;
  for (const auto& goal : goal_statements(hypotheses, expanded(step, step.claim.formula))) {
    Step question = step;
    question.hypotheses = premises_of(goal);
    question.abbreviations.clear();
    question.constants.clear();
    question.claim = {"contradiction", "1 <= 0", contradiction()};
    const std::string premises = text_of_premises(question.hypotheses);
    if (!seen.insert(premises).second) continue;
    const StepOutcome outcome = prove(question, limits);
    if (is_refuted(outcome.verdict)) {
      if (seen.size() == 1) result.point = outcome.counterexample;
      continue;
    }
    if (is_undecided(outcome.verdict) && is_undecided(result.verdict)) continue;
    result.verdict = outcome.verdict;
    result.premises = premises;
    if (is_proved(outcome.verdict)) break;
  }
  if (!is_refuted(result.verdict)) result.point.clear();
  return result;
}

}  // namespace delcert
