#include "proofs/prover/prover.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernel/formula/formula_text.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/prover/goal.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Parameters = std::map<std::string, StepRange>;

/// Nothing for integers that do not fit.
std::optional<Bindings> bindings_at(const Parameters& parameters, const std::map<std::string, Rational>& point) {
  Bindings result;
  for (const auto& [name, range] : parameters) {
    const Rational& value = point.at(name);
    if (!range.is_integer) {
      result[name] = value;
      continue;
    }
    const Rational greatest(1000000000000000000L);
    if (absolute(value) > greatest) return std::nullopt;
    result[name] = static_cast<long>(value.numerator());
  }
  return result;
}

Verdict decide(const Expression& statement, const Bindings& bindings) {
  Scene scene(bindings);
  try {
    return decide_statement(statement, scene);
  } catch (const Undecided&) {
    return Verdict::undecided;
  } catch (const InputError&) {
    return Verdict::undecided;
  }
}

struct Expanded {
  std::vector<ExpressionPointer> hypotheses;
  ExpressionPointer claim;
};

Expanded expanded_parts(const Step& step, const std::map<std::string, Rational>& constants) {
  Expanded result;
  for (const Statement& hypothesis : step.hypotheses) {
    result.hypotheses.push_back(expanded(step, constants, hypothesis.formula));
  }
  result.claim = expanded(step, constants, step.claim.formula);
  return result;
}

Verdict value_at(const Expanded& parts, const Bindings& bindings) {
  Verdict hypotheses = Verdict::proved;
  for (const auto& hypothesis : parts.hypotheses) {
    hypotheses = conjunction(hypotheses, decide(*hypothesis, bindings));
    if (is_refuted(hypotheses)) return Verdict::proved;
  }
  return disjunction(negation(hypotheses), decide(*parts.claim, bindings));
}

/// An exponent whose value is not always an integer or half of one leaves a power undefined, which the search, for
/// which integers are real numbers, does not see. Empty if there is none.
std::string wrong_exponent(const Expression& term, RationalFunctionReader& reader) {
  if (term.operation == Operation::power) {
    const auto exponent = reader.read(*term.children[1]);
    bool fits = exponent && exponent->denominator.constant();
    if (fits) {
      const Rational divisor = *exponent->denominator.constant();
      for (const auto& part : exponent->numerator.terms()) {
        fits = fits && (Rational(2) * part.coefficient / divisor).denominator() == 1;
      }
    }
    if (!fits) {
      return "the exponent " + formula_text(*term.children[1]) + " is not seen to be an integer or half of one always";
    }
  }
  for (const auto& child : term.children) {
    std::string found = wrong_exponent(*child, reader);
    if (!found.empty()) return found;
  }
  return "";
}

std::string wrong_exponent(const Expanded& parts, const Parameters& parameters) {
  std::vector<std::string> names;
  for (const auto& [name, range] : parameters) names.push_back(name);
  RationalFunctionReader reader(std::make_shared<const PolynomialRing>(names), std::vector<bool>(names.size(), false),
                                [](const Polynomial&) { return Sign::unknown; });
  for (const auto& hypothesis : parts.hypotheses) {
    std::string found = wrong_exponent(*hypothesis, reader);
    if (!found.empty()) return found;
  }
  return wrong_exponent(*parts.claim, reader);
}

std::string method_of(const std::vector<GoalOutcome>& goals) {
  std::string result;
  for (const GoalOutcome& outcome : goals) {
    const std::string method = outcome.squares ? "squares" : outcome.goal.method();
    result = result.empty() || result == method ? method : "mixed";
  }
  return result;
}

}  // namespace

StepOutcome prove(const Step& step, const std::map<std::string, Rational>& constants, const SearchLimits& limits) {
  const Expanded parts = expanded_parts(step, constants);
  StepOutcome outcome;
  const std::string reason = wrong_exponent(parts, step.parameters);
  if (!reason.empty()) {
    outcome.left.push_back(reason);
    return outcome;
  }
  outcome.verdict = Verdict::proved;
  for (const auto& statement : goal_statements(parts.hypotheses, parts.claim)) {
    Goal goal = make_goal(statement, step.parameters);
    const DecideAt at = [&](const std::vector<Rational>& values) {
      std::map<std::string, Rational> point;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!goal.ranges[i].contains(values[i])) return Verdict::undecided;
        point[goal.names[i]] = values[i];
      }
      const auto bindings = bindings_at(step.parameters, point);
      if (!bindings) return Verdict::undecided;
      const Verdict of_goal = decide(*goal.statement, *bindings);
      return is_refuted(of_goal) ? value_at(parts, *bindings) : of_goal;
    };
    SearchResult result = search(goal, at, limits);
    std::optional<SquaresProof> squares;
    if (is_undecided(result.verdict)) squares = squares_proof(goal);
    if (squares) {
      result.verdict = Verdict::proved;
      result.left.clear();
    }
    outcome.boxes += result.boxes;
    outcome.verdict = result.verdict;
    for (const Box& box : result.left) outcome.left.push_back(box_text(box, goal.names));
    for (std::size_t i = 0; i < result.counterexample.size(); ++i) {
      outcome.counterexample[goal.names[i]] = result.counterexample[i];
    }
    outcome.goals.push_back({std::move(goal), std::move(result), std::move(squares)});
    if (!is_proved(outcome.verdict)) break;
  }
  outcome.method = method_of(outcome.goals);
  return outcome;
}

StepOutcome prove(const Step& step, const SearchLimits& limits) { return prove(step, step.constants, limits); }

Verdict decide_at(const Step& step, const std::map<std::string, Rational>& constants,
                  const std::map<std::string, Rational>& point) {
  for (const auto& [name, range] : step.parameters) {
    if (!range.contains(point.at(name))) return Verdict::undecided;
  }
  const auto bindings = bindings_at(step.parameters, point);
  return bindings ? value_at(expanded_parts(step, constants), *bindings) : Verdict::undecided;
}

}  // namespace delcert
