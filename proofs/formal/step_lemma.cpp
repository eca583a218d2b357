#include "proofs/formal/step_lemma.hpp"

#include "proofs/formal/comparison_script.hpp"
#include "proofs/formal/squares_script.hpp"
#include "proofs/formal/terms.hpp"
#include "proofs/prover/prover.hpp"

namespace delcert {

namespace {

class Proof {
 public:
  explicit Proof(FormalParameters parameters, SquaresScript squares = {})
      : parameters_(std::move(parameters)), squares_(std::move(squares)) {}

  /// The tactics for a claim, and whether they only check.
  std::string of(const ExpressionPointer& claim) {
    switch (claim->operation) {
      case Operation::conjunction:
        return "split.\n{\n" + of(claim->children[0]) + "}\n{\n" + of(claim->children[1]) + "}\n";
      case Operation::implication: {
        ++premises_;
        std::string result = "intros premise_" + std::to_string(premises_) + ".\n" + of(claim->children[1]);
        --premises_;
        return result;
      }
      case Operation::less:
      case Operation::less_equal:
      case Operation::greater:
      case Operation::greater_equal:
      case Operation::equal:
        return comparison(claim);
      default:
        return search();
    }
  }

  [[nodiscard]] const FormalParameters& parameters() const { return parameters_; }
  [[nodiscard]] bool searches() const { return searches_; }
  [[nodiscard]] const std::set<std::size_t>& wanted_squares() const { return wanted_; }

 private:
  std::string comparison(const ExpressionPointer& claim) {
    if (auto extreme = by_parts(claim)) return *extreme;
    const ComparisonScript script = comparison_script(claim, parameters_, squares_.signs);
    wanted_.insert(script.wanted_squares.begin(), script.wanted_squares.end());
    // Coq handles long terms badly: what has become of a high power is left to enclosures.
    constexpr std::size_t longest = 12000;
    constexpr std::size_t longest_with_squares = 60000;
    const std::size_t most = squares_.signs.empty() ? longest : longest_with_squares;
    return script.tactics && script.tactics->size() < most ? squares_.facts + *script.tactics : search();
  }

  /// max(a, b) <= c, c <= min(a, b) and |a| <= c are two comparisons each.
  std::optional<std::string> by_parts(const ExpressionPointer& claim) {
    const bool turned = claim->operation == Operation::greater || claim->operation == Operation::greater_equal;
    const ExpressionPointer& low = claim->children[turned ? 1 : 0];
    const ExpressionPointer& high = claim->children[turned ? 0 : 1];
    const bool strict = claim->operation == Operation::less || claim->operation == Operation::greater;
    if (claim->operation == Operation::equal) return std::nullopt;
    const Operation relation = strict ? Operation::less : Operation::less_equal;
    const std::string turn = turned ? (strict ? "apply Rlt_gt; " : "apply Rle_ge; ") : "";
    const auto both = [&](const std::string& lemma, const ExpressionPointer& first, const ExpressionPointer& second) {
      return turn + "apply " + lemma + ".\n{\n" + of(first) + "}\n{\n" + of(second) + "}\n";
    };
    const auto is_pair = [](const ExpressionPointer& term, std::string_view name) {
      return term->operation == Operation::call && term->text == name && term->children.size() == 2;
    };
    if (is_pair(low, "max")) {
      return both(strict ? "Rmax_lub_lt" : "Rmax_lub", binary_term(relation, low->children[0], high),
                  binary_term(relation, low->children[1], high));
    }
    if (is_pair(high, "min")) {
      return both(strict ? "Rmin_glb_lt" : "Rmin_glb", binary_term(relation, low, high->children[0]),
                  binary_term(relation, low, high->children[1]));
    }
    if (low->operation == Operation::call && low->text == "abs") {
      auto minus = std::make_shared<Expression>(*number_term(Rational(0)));
      minus->operation = Operation::negate;
      minus->children = {high};
      return both(strict ? "abs_below" : "abs_at_most", binary_term(relation, minus, low->children[0]),
                  binary_term(relation, low->children[0], high));
    }
    return std::nullopt;
  }

  std::string search() {
    searches_ = true;
    std::string cuts;
    for (const FormalParameter& parameter : parameters_) {
      if (parameter.range.lower && parameter.range.upper) cuts += ", i_bisect " + parameter.variable().text;
    }
    return "first\n  [ lra\n  | timeout 15 nra\n  | timeout 15 (try unfold Rpower; interval with (i_prec 60))\n"
           "  | timeout 25 (try unfold Rpower; interval with (i_prec 60" +
           cuts + ")) ].\n";
  }

  FormalParameters parameters_;
  SquaresScript squares_;
  std::set<std::size_t> wanted_;
  bool searches_ = false;
  int premises_ = 0;
};

/// The tactics for a claim of one comparison, by the sums of squares that the prover has found.
std::optional<StepLemma> by_squares(const ExpressionPointer& claim, const StepOutcome& outcome,
                                    const FormalParameters& parameters, const std::string& before,
                                    const std::string& after) {
  if (!is_proved(outcome.verdict) || outcome.goals.size() != 1 || !outcome.goals[0].squares) return std::nullopt;
  auto squares = squares_script(outcome.goals[0].goal, *outcome.goals[0].squares, parameters);
  if (!squares) return std::nullopt;
  const std::string definitions = squares->definitions;
  Proof proof(parameters, std::move(*squares));
  const std::string tactics = proof.of(claim);
  if (proof.searches() || !proof.wanted_squares().empty()) return std::nullopt;
  return StepLemma{before + " certificates.\nOpen Scope R_scope.\n\n" + definitions + after + tactics + "Qed.\n",
                   StepLemma::Method::certificate};
}

/// No formula has anything in it that would end a comment.
std::string comment(const Step& step) {
  const std::string lines = step.lines.empty() ? "" : ", lines " + step.lines + " of the paper";
  return "(* " + step.name + lines + ": " + step.claim.text + " *)\n";
}

/// "forall k u : R," and the ranges and hypotheses, each followed by an arrow; nothing if one cannot be said in Coq.
std::optional<std::string> premises(const Step& step, const std::map<std::string, Rational>& constants,
                                    const FormalParameters& parameters) {
  std::string result;
  for (const FormalParameter& parameter : parameters) result += " " + coq_name(parameter.name);
  if (!result.empty()) result = "forall" + result + " : R,\n" + range_premises(parameters);
  for (const Statement& hypothesis : step.hypotheses) {
    const auto printed = coq_of(*expanded(step, constants, hypothesis.formula));
    if (!printed) return std::nullopt;
    result += "  " + *printed + " ->\n";
  }
  return result;
}

std::string refutation(const Step& step, const FormalParameters& parameters, const std::string& statement,
                       const std::map<std::string, Rational>& counterexample, const std::string& name) {
  std::string values;
  std::size_t premises = step.hypotheses.size();
  for (const FormalParameter& parameter : parameters) {
    values += " " + coq_number(counterexample.at(parameter.name));
    premises += (parameter.range.lower ? 1U : 0U) + (parameter.range.upper ? 1U : 0U);
  }
  for (std::size_t at = 0; at < premises; ++at) values += " ltac:(number)";
  return "From Delcert Require Import enclosure refutations.\nOpen Scope R_scope.\n\nLemma " + name + "_refuted : ~ (" +
         statement + ").\nProof.\nintros H; specialize (H" + values + ").\nrefute H.\nQed.\n";
}

}  // namespace

std::string_view name_of(StepLemma::Method method) {
  switch (method) {
    case StepLemma::Method::certificate:
      return "certificate";
    case StepLemma::Method::search:
      return "search";
    default:
      return "refutation";
  }
}

std::optional<StepLemma> step_lemma(const Step& step, const std::map<std::string, Rational>& constants,
                                    const std::string& name) {
  const ExpressionPointer claim = expanded(step, constants, step.claim.formula);
  FormalParameters parameters = formal_parameters(step);
  const auto before = premises(step, constants, parameters);
  const auto printed = coq_of(*claim);
  if (!before || !printed) return std::nullopt;
  const std::string statement = *before + "  " + *printed;
  const std::string header = comment(step) + "Require Import Reals Lra Lia Psatz.\n";

  // Until no root is met whose argument could be made a square.
  for (;;) {
    Proof proof(parameters);
    const std::string tactics = proof.of(claim);
    bool changed = false;
    for (const std::size_t at : proof.wanted_squares()) {
      changed = changed || !parameters[at].is_squared;
      parameters[at].is_squared = true;
    }
    if (changed) continue;
    if (proof.searches()) {
      const StepOutcome outcome = prove(step, constants);
      if (is_refuted(outcome.verdict) && outcome.counterexample.size() == parameters.size()) {
        return StepLemma{header + refutation(step, parameters, statement, outcome.counterexample, name),
                         StepLemma::Method::refutation};
      }
      const std::string after =
          "Lemma " + name + " :\n" + statement + ".\nProof.\n" + introduction(parameters, step.hypotheses.size());
      auto lemma = by_squares(claim, outcome, parameters, header + "From Delcert Require Import", after);
      if (lemma) return lemma;
    }
    return StepLemma{header + "From Delcert Require Import certificates" + (proof.searches() ? " enclosure" : "") +
                         ".\nOpen Scope R_scope.\n\nLemma " + name + " :\n" + statement + ".\nProof.\n" +
                         introduction(parameters, step.hypotheses.size()) + tactics + "Qed.\n",
                     proof.searches() ? StepLemma::Method::search : StepLemma::Method::certificate};
  }
}

}  // namespace delcert
