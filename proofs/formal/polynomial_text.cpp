#include "proofs/formal/polynomial_text.hpp"

#include "proofs/formula/coq.hpp"

namespace delcert {

std::string power_text(const std::string& base, unsigned long exponent) {
  return exponent == 1 ? base : base + " ^ " + std::to_string(exponent);
}

std::string polynomial_text(const Polynomial& polynomial, const FormalVariables& variables) {
  std::string result;
  for (const auto& [coefficient, exponents] : polynomial.terms()) {
    const bool negative = coefficient < Rational(0);
    const Rational size = absolute(coefficient);
    std::string term;
    for (std::size_t at = 0; at < exponents.size(); ++at) {
      if (exponents[at] == 0) continue;
      term += (term.empty() ? "" : " * ") + power_text(variables.at(at).text, exponents[at]);
    }
    if (term.empty()) {
      term = coq_number(size);
    } else if (size != Rational(1)) {
      term = coq_number(size) + " * " + term;
    }
    result += result.empty() ? (negative ? "- " : "") : (negative ? " - " : " + ");
    result += term;
  }
  if (result.empty()) return "0";
  // A name, a number or a number in parentheses stands for itself.
  return result.find(' ') == std::string::npos ? result : "(" + result + ")";
}

}  // namespace delcert
