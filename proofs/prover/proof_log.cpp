#include "proofs/prover/proof_log.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "kernel/number/fraction_text.hpp"
#include "proofs/certificate/sha256.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

std::string operator_of(const Expression& expression) {
  switch (expression.operation) {
    case Operation::negate:
    case Operation::subtract:
      return "-";
    case Operation::add:
      return "+";
    case Operation::multiply:
      return "*";
    case Operation::divide:
      return "/";
    case Operation::power:
      return "^";
    case Operation::less:
      return "<";
    case Operation::less_equal:
      return "<=";
    case Operation::greater:
      return ">";
    case Operation::greater_equal:
      return ">=";
    case Operation::equal:
      return "=";
    case Operation::negation:
      return "not";
    case Operation::conjunction:
      return "and";
    case Operation::disjunction:
      return "or";
    case Operation::implication:
      return "implies";
    case Operation::call:
      return expression.text;
    default:
      throw std::logic_error("what has no S-expression");
  }
}

Json end_of(const std::optional<Rational>& end) { return end ? Json(fraction_text(*end)) : Json(nullptr); }

Json tree_of(const GoalOutcome& outcome, std::size_t at) {
  const ProofNode& node = outcome.result.nodes[at];
  if (!node.cut) return node.is_exact ? "exact" : "leaf";
  return Json::array({outcome.goal.names[node.cut->side], fraction_text(node.cut->lower_part),
                      fraction_text(node.cut->upper_part), tree_of(outcome, node.lower), tree_of(outcome, node.upper)});
}

Json atom_of(const Atom& atom) {
  if (!atom.polynomial) return Json{{"by", "enclosure"}};
  Json powers = Json::array();
  for (const auto& power : atom.polynomial->powers) powers.push_back({power.factor, power.exponent});
  return Json{{"by", "polynomial"},
              {"constant", fraction_text(atom.polynomial->constant)},
              {"powers", powers},
              {"divisors", atom.polynomial->divisors}};
}

Json constraint_of(const SquaresConstraint& constraint, const Goal& goal) {
  switch (constraint.kind) {
    case SquaresConstraint::Kind::lower_end:
      return {"lower", goal.names[constraint.number]};
    case SquaresConstraint::Kind::upper_end:
      return {"upper", goal.names[constraint.number]};
    default:
      return {"comparison", constraint.number, constraint.is_turned};
  }
}

/// 2 positive, 1 not negative, and so on.
int number_of(Sign sign) {
  switch (sign) {
    case Sign::positive:
      return 2;
    case Sign::nonnegative:
      return 1;
    case Sign::nonpositive:
      return -1;
    case Sign::negative:
      return -2;
    default:
      return 0;
  }
}

Json squares_of(const SquaresProof& proof, const Goal& goal) {
  Json constraints = Json::array();
  for (const SquaresConstraint& constraint : proof.constraints) {
    constraints.push_back(constraint_of(constraint, goal));
  }
  Json signs = Json::array();
  for (const FactorSign& sign : proof.signs) {
    Json one{{"factor", sign.factor}, {"sign", number_of(sign.sign)}};
    for (const SquareTerm& term : sign.terms) {
      one["terms"].push_back(
          Json{{"weight", fraction_text(term.weight)}, {"base", term.base.text()}, {"times", term.constraints}});
    }
    signs.push_back(std::move(one));
  }
  return Json{{"constraints", constraints}, {"signs", signs}};
}

Json goal_of(const GoalOutcome& outcome) {
  const Goal& goal = outcome.goal;
  Json squared = Json::array();
  for (std::size_t i = 0; i < goal.names.size(); ++i) {
    if (goal.is_squared[i]) squared.push_back(goal.names[i]);
  }
  Json factors = Json::array();
  for (const Polynomial& factor : goal.factors) factors.push_back(factor.text());
  Json atoms = Json::array();
  for (const Atom& atom : goal.atoms) atoms.push_back(atom_of(atom));
  Json trees = Json::array();
  if (!outcome.squares) {
    for (const std::size_t root : outcome.result.roots) trees.push_back(tree_of(outcome, root));
  }
  Json result{
      {"statement", s_expression(*goal.statement)}, {"squared", squared}, {"factors", factors}, {"atoms", atoms},
      {"precision", enclosure_precision.value},     {"trees", trees}};
  if (outcome.squares) result["squares"] = squares_of(*outcome.squares, goal);
  return result;
}

}  // namespace

std::string s_expression(const Expression& expression) {
  if (expression.operation == Operation::literal) return fraction_text(expression.value);
  if (expression.operation == Operation::name) return expression.text;
  std::string result = "(" + operator_of(expression);
  for (const auto& child : expression.children) result += " " + s_expression(*child);
  return result + ")";
}

std::string proof_log_line(const std::string& claim, const Step& step, const std::map<std::string, Rational>& constants,
                           const StepOutcome& outcome) {
  Json parameters = Json::array();
  for (const auto& [name, range] : step.parameters) {
    parameters.push_back(Json{{"name", name},
                              {"integer", range.is_integer},
                              {"lower", end_of(range.lower)},
                              {"has_lower", range.has_lower},
                              {"upper", end_of(range.upper)},
                              {"has_upper", range.has_upper}});
  }
  Json hypotheses = Json::array();
  for (const Statement& hypothesis : step.hypotheses) {
    hypotheses.push_back(s_expression(*expanded(step, constants, hypothesis.formula)));
  }
  Json goals = Json::array();
  for (const GoalOutcome& goal : outcome.goals) goals.push_back(goal_of(goal));
  return Json{{"claim", claim},
              {"step", step.name},
              {"parameters", parameters},
              {"hypotheses", hypotheses},
              {"statement", s_expression(*expanded(step, constants, step.claim.formula))},
              {"goals", goals}}
             .dump() +
         "\n";
}

std::string proof_log_head(const std::string& claim, const std::string& file, const std::string& text) {
  Sha256 hash;
  hash.update(text);
  return Json{{"format", "delcert-proof-log"}, {"version", 2}, {"claim", claim}, {"file", file},
              {"sha256", hash.digest()},       {"text", text}}
             .dump() +
         "\n";
}

}  // namespace delcert
