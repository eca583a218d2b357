#include "proofs/formal/symbolic_powers.hpp"

#include <algorithm>

#include "proofs/formal/terms.hpp"
#include "proofs/prover/rational_function.hpp"

namespace delcert {

namespace {

RationalFunctionReader plain_reader(const RingPointer& ring) {
  return {ring, std::vector<bool>(ring->variable_count(), false), [](const Polynomial&) { return Sign::unknown; }};
}

std::vector<std::string> names_of(const FormalParameters& parameters) {
  std::vector<std::string> result;
  for (const FormalParameter& parameter : parameters) result.push_back(parameter.name);
  return result;
}

std::string joined(const std::string& product, const std::string& factor) {
  return product.empty() ? factor : product + " * " + factor;
}

}  // namespace

SymbolicPowers::SymbolicPowers(const FormalParameters& parameters)
    : parameters_(parameters), ring_(std::make_shared<PolynomialRing>(names_of(parameters))) {}

std::optional<ExpressionPointer> SymbolicPowers::replaced(const ExpressionPointer& term) {
  if (term->operation == Operation::power && !rational_constant(*term->children[1])) return replaced_power(term);
  std::vector<ExpressionPointer> children;
  for (const auto& child : term->children) {
    auto changed = replaced(child);
    if (!changed) return std::nullopt;
    children.push_back(std::move(*changed));
  }
  return with_children(term, std::move(children));
}

/// A base as a product of powers of parameters and numbers, each at most 1 or at least 1.
std::optional<std::vector<SymbolicPowers::Part>> SymbolicPowers::parts(const ExpressionPointer& base) const {
  const auto value = plain_reader(ring_).read(*base);
  if (!value || value->numerator.is_zero()) return std::nullopt;
  std::vector<Part> result;
  Rational constant(1);
  for (const auto& [polynomial, sign] : {std::pair(&value->numerator, 1L), std::pair(&value->denominator, -1L)}) {
    const auto terms = polynomial->terms();
    if (terms.size() != 1) return std::nullopt;
    constant *= sign > 0 ? terms[0].coefficient : Rational(1) / terms[0].coefficient;
    for (std::size_t at = 0; at < terms[0].exponents.size(); ++at) {
      if (terms[0].exponents[at] == 0) continue;
      const FormalParameter& parameter = parameters_[at];
      const auto& range = parameter.range;
      if (!range.lower || *range.lower < Rational(0) || (*range.lower == Rational(0) && range.has_lower)) {
        return std::nullopt;
      }
      const bool above_one = *range.lower >= Rational(1);
      if (!above_one && !(range.upper && *range.upper <= Rational(1))) return std::nullopt;
      result.push_back(
          {parameter.text(), name_term(parameter.name), sign * static_cast<long>(terms[0].exponents[at]), above_one});
    }
  }
  if (constant <= Rational(0)) return std::nullopt;
  if (constant != Rational(1)) {
    result.push_back({coq_number(constant), number_term(constant), 1, constant > Rational(1)});
  }
  return result;
}

/// An exponent as a polynomial in p − a for the parameters p and their lower ends a.
std::optional<std::vector<SymbolicPowers::Monomial>> SymbolicPowers::monomials(const Expression& exponent) const {
  const auto value = plain_reader(ring_).read(exponent);
  if (!value || !value->denominator.constant()) return std::nullopt;
  Polynomial shifted(ring_);
  for (const auto& [coefficient, exponents] : value->numerator.terms()) {
    Polynomial term(ring_, coefficient / *value->denominator.constant());
    for (std::size_t at = 0; at < exponents.size(); ++at) {
      if (exponents[at] == 0) continue;
      if (!parameters_[at].range.lower) return std::nullopt;
      const Polynomial sum = Polynomial(ring_, *parameters_[at].range.lower) + Polynomial::variable(ring_, at);
      term = term * sum.power(exponents[at]);
    }
    shifted = shifted + term;
  }
  std::vector<Monomial> result;
  for (const auto& [coefficient, exponents] : shifted.terms()) {
    Monomial monomial{coefficient, ""};
    for (std::size_t at = 0; at < exponents.size(); ++at) {
      if (exponents[at] == 0) continue;
      const Rational& lower = *parameters_[at].range.lower;
      const std::string text = parameters_[at].text();
      const std::string difference = lower == Rational(0) ? text : "(" + text + " - " + coq_number(lower) + ")";
      monomial.text = joined(monomial.text, power_text(difference, exponents[at]));
    }
    result.push_back(std::move(monomial));
  }
  return result;
}

/// The name of the variable that stands for the power of a part; a new one if there is none yet.
std::string SymbolicPowers::variable(const Part& part, const std::string& exponent) {
  const std::string power = "Rpower " + part.text + " (" + exponent + ")";
  const auto known = known_.find(power);
  if (known != known_.end()) return known->second;
  const std::string name = "power_" + std::to_string(variables_.size() + 1);
  known_[power] = name;
  introductions_ += "pose (" + name + " := " + power + ").\n";
  introductions_ += "assert (" + name + "_positive : 0 < " + name + ") by apply power_positive.\n";
  const std::string bound = part.above_one ? "1 <= " + name : name + " <= 1";
  introductions_ += "assert (" + name + "_bound : " + bound + ") by (apply " +
                    (part.above_one ? "power_at_least_one" : "power_at_most_one") + "; [nra | nonneg]).\n";
  FormalVariable result{name, Rational(part.above_one ? 1 : 0), std::nullopt, !part.above_one, false};
  if (!part.above_one) result.upper = Rational(1);
  variables_.push_back(result);
  return name;
}

std::optional<ExpressionPointer> SymbolicPowers::replaced_power(const ExpressionPointer& term) {
  const auto base_parts = parts(term->children[0]);
  const auto exponent = monomials(*term->children[1]);
  if (!base_parts || !exponent) return std::nullopt;
  ExpressionPointer result = number_term(Rational(1));
  for (const Part& part : *base_parts) {
    for (const Monomial& monomial : *exponent) {
      const Integer denominator = monomial.coefficient.denominator();
      const Integer numerator = monomial.coefficient.numerator() * part.exponent;
      constexpr long greatest = 1000;
      if (abs(numerator) > greatest) return std::nullopt;
      ExpressionPointer factor = part.term;
      if (!monomial.text.empty() || denominator != 1) {
        std::string scaled = monomial.text.empty() ? "1" : monomial.text;
        if (denominator != 1) scaled = coq_number(Rational(Integer(1), denominator)) + " * (" + scaled + ")";
        factor = name_term(variable(part, scaled));
      }
      const bool inverse = numerator < 0;
      const ExpressionPointer raised = power_term(factor, static_cast<long>(Integer(abs(numerator))));
      result = binary_term(inverse ? Operation::divide : Operation::multiply, result, raised);
    }
  }
  const CoqNames names = coq_names(parameters_);
  const auto left = coq_of(*term, names);
  const auto right = coq_of(*result, names);
  if (!left || !right) return std::nullopt;
  const std::string fact = *left + " = " + *right;
  if (std::find(facts_.begin(), facts_.end(), fact) == facts_.end()) facts_.push_back(fact);
  return result;
}

std::string SymbolicPowers::script() const {
  std::string result = introductions_;
  std::string unfolded;
  for (const FormalVariable& variable : variables_) unfolded += (unfolded.empty() ? "" : ", ") + variable.text;
  for (std::size_t at = 0; at < facts_.size(); ++at) {
    const std::string name = "power_fact_" + std::to_string(at + 1);
    result += "assert (" + name + " : " + facts_[at] + ").\n{ " +
              (unfolded.empty() ? "" : "unfold " + unfolded + "; ") + "apply power_is; [positive | logarithms]. }\n";
    result += "try rewrite " + name + "; clear " + name + ".\n";
  }
  for (const FormalVariable& variable : variables_) result += "clearbody " + variable.text + ".\n";
  return result;
}

}  // namespace delcert
