#include "proofs/formal/sign_script.hpp"

#include "proofs/formal/bernstein_form.hpp"
#include "proofs/formal/domination.hpp"
#include "proofs/formula/coq.hpp"

namespace delcert {

namespace {

/// A place inside a range, near 1 if it is unbounded.
Rational inside(const FormalVariable& variable) {
  if (variable.lower && variable.upper) return (*variable.lower + *variable.upper) / Rational(2);
  if (variable.lower) return *variable.lower + maximum(Rational(1), absolute(*variable.lower));
  if (variable.upper) return *variable.upper - maximum(Rational(1), absolute(*variable.upper));
  return Rational(0);
}

class SignSearch {
 public:
  SignSearch(const Polynomial& polynomial, bool strict)
      : polynomial_(polynomial), degrees_(polynomial.degrees()), strict_(strict) {}

  std::optional<std::string> script(const FormalVariables& variables, int depth) {
    std::optional<std::string> form = domination(polynomial_, variables, strict_);
    if (!form) form = bernstein_form(polynomial_, variables, strict_);
    if (form) {
      return "replace " + polynomial_text(polynomial_, variables) + " with " + *form + " by field; " +
             (strict_ ? "positive." : "nonneg.");
    }
    constexpr int deepest = 5;
    if (depth == deepest) return std::nullopt;
    for (std::size_t tried = 0; tried < degrees_.size(); ++tried) {
      const std::size_t at = (tried + static_cast<std::size_t>(depth)) % degrees_.size();
      if (degrees_[at] == 0) continue;
      return halves(variables, at, depth);
    }
    return std::nullopt;
  }

 private:
  std::optional<std::string> halves(const FormalVariables& variables, std::size_t at, int depth) {
    const Rational middle = inside(variables[at]);
    FormalVariables left = variables;
    left[at].upper = middle;
    left[at].upper_open = false;
    FormalVariables right = variables;
    right[at].lower = middle;
    right[at].lower_open = true;
    const auto first = script(left, depth + 1);
    if (!first) return std::nullopt;
    const auto second = script(right, depth + 1);
    if (!second) return std::nullopt;
    const std::string cut = "cut_" + std::to_string(++cuts_);
    return "destruct (Rle_lt_dec " + variables[at].text + " " + coq_number(middle) + ") as [" + cut + "|" + cut +
           "].\n{ " + *first + " }\n{ " + *second + " }";
  }

  const Polynomial& polynomial_;
  std::vector<unsigned long> degrees_;
  bool strict_;
  int cuts_ = 0;
};

}  // namespace

std::optional<std::string> sign_script(const Polynomial& polynomial, const FormalVariables& variables, bool strict) {
  return SignSearch(polynomial, strict).script(variables, 0);
}

int sign_at_some_point(const Polynomial& polynomial, const FormalVariables& variables) {
  Rational value(0);
  for (const auto& [coefficient, exponents] : polynomial.terms()) {
    Rational term = coefficient;
    for (std::size_t at = 0; at < exponents.size(); ++at) {
      term *= power(inside(variables.at(at)), static_cast<long>(exponents[at]));
    }
    value += term;
  }
  if (value == Rational(0)) return 0;
  return value < Rational(0) ? -1 : 1;
}

}  // namespace delcert
