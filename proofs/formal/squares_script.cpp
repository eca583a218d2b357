#include "proofs/formal/squares_script.hpp"

#include <algorithm>

#include "proofs/formal/polynomial_text.hpp"

namespace delcert {

namespace {

constexpr const char* sum_of_squares_tactic =
    "Ltac sum_of_squares :=\n"
    "  lazymatch goal with\n"
    "  | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; sum_of_squares\n"
    "  | |- 0 <= _ * _ => apply Rmult_le_pos; sum_of_squares\n"
    "  | |- 0 <= _ ^ 2 => apply square_nonneg\n"
    "  | |- _ => first [assumption | lra]\n"
    "  end.\n\n";

class SquaresPrinter {
 public:
  SquaresPrinter(const SquaresProof& proof, FormalVariables variables)
      : proof_(proof), variables_(std::move(variables)) {}

  std::string facts() const {
    std::string result;
    for (std::size_t i = 0; i < proof_.constraints.size(); ++i) {
      const bool is_used = std::any_of(proof_.signs.begin(), proof_.signs.end(), [i](const FactorSign& sign) {
        return std::any_of(sign.terms.begin(), sign.terms.end(), [i](const SquareTerm& term) {
          return std::find(term.constraints.begin(), term.constraints.end(), i) != term.constraints.end();
        });
      });
      if (is_used)
        result += "assert (constraint_" + std::to_string(i) + " : 0 <= " + constraint_text(i) + ") by lra.\n";
    }
    return result;
  }

  /// What is strict has a constant among its terms, which goes last.
  KnownSign script(const Polynomial& polynomial, const std::vector<SquareTerm>& terms, bool strict) const {
    std::string sum;
    std::string constant;
    for (const SquareTerm& term : terms) {
      if (strict && constant.empty() && term.constraints.empty() && term.base.constant()) {
        constant = coq_number(term.weight * square(*term.base.constant()));
      } else {
        sum += (sum.empty() ? "" : " + ") + term_text(term);
      }
    }
    const std::string replace = "replace " + polynomial_text(polynomial, variables_) + " with ";
    if (!strict) return {false, replace + "(" + sum + ") by field; sum_of_squares."};
    if (sum.empty()) return {true, replace + constant + " by field; lra."};
    return {true, replace + "((" + sum + ") + " + constant + ") by field; apply Rplus_le_lt_0_compat; " +
                      "[sum_of_squares | lra]."};
  }

 private:
  /// In parentheses whatever it is made of, so that it is found again as it stands.
  std::string constraint_text(std::size_t at) const {
    return "(" + polynomial_text(proof_.constraints.at(at).polynomial, variables_) + ")";
  }

  std::string term_text(const SquareTerm& term) const {
    std::string result = coq_number(term.weight) + " * " + polynomial_text(term.base, variables_) + " ^ 2";
    for (const std::size_t constraint : term.constraints) result += " * " + constraint_text(constraint);
    return result;
  }

  const SquaresProof& proof_;
  FormalVariables variables_;
};

}  // namespace

std::optional<SquaresScript> squares_script(const Goal& goal, const SquaresProof& proof,
                                            const FormalParameters& parameters) {
  const auto is_squared = [](const FormalParameter& parameter) { return parameter.is_squared; };
  if (std::any_of(parameters.begin(), parameters.end(), is_squared) ||
      std::find(goal.is_squared.begin(), goal.is_squared.end(), true) != goal.is_squared.end()) {
    return std::nullopt;
  }
  FormalVariables variables;
  for (const FormalParameter& parameter : parameters) variables.push_back(parameter.variable());
  const SquaresPrinter printer(proof, std::move(variables));
  SquaresScript result{sum_of_squares_tactic, printer.facts(), {}};
  for (const FactorSign& sign : proof.signs) {
    if (sign.terms.empty()) continue;
    const bool is_negative = sign.sign == Sign::negative || sign.sign == Sign::nonpositive;
    const Polynomial polynomial = is_negative ? -goal.factors[sign.factor] : goal.factors[sign.factor];
    result.signs[polynomial.text()] = printer.script(polynomial, sign.terms, is_strict(sign.sign));
  }
  return result;
}

}  // namespace delcert
