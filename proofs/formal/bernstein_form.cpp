#include "proofs/formal/bernstein_form.hpp"

#include <algorithm>

#include "proofs/formula/coq.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_coefficients = 4000;

Rational binomial(unsigned long n, unsigned long k) {
  Rational result(1);
  for (unsigned long i = 1; i <= k; ++i) result *= Rational(n - k + i) / Rational(i);
  return result;
}

/// "(x - 1)", or x itself for 0.
std::string above(const FormalVariable& variable) {
  if (*variable.lower == Rational(0)) return variable.text;
  return "(" + variable.text + " - " + coq_number(*variable.lower) + ")";
}

std::string below(const FormalVariable& variable) {
  return "(" + coq_number(*variable.upper) + " - " + variable.text + ")";
}

/// The coefficients in one variable after another, the last running fastest.
class Tensor {
 public:
  Tensor(const Polynomial& polynomial, const FormalVariables& variables) : variables_(variables) {
    degrees_ = polynomial.degrees();
    degrees_.resize(variables.size());
    std::size_t size = 1;
    for (std::size_t at = 0; at < degrees_.size(); ++at) {
      size *= degrees_[at] + 1;
      const bool has_end = variables[at].lower.has_value() || variables[at].upper.has_value();
      if (size > most_coefficients || (degrees_[at] > 0 && !has_end)) return;
    }
    coefficients_.resize(size);
    for (const auto& [coefficient, exponents] : polynomial.terms()) {
      std::size_t index = 0;
      for (std::size_t at = 0; at < degrees_.size(); ++at) index = index * (degrees_[at] + 1) + exponents[at];
      coefficients_[index] = coefficient;
    }
    for (std::size_t at = 0; at < degrees_.size(); ++at) change_basis(at);
  }

  [[nodiscard]] std::optional<std::string> form(bool strict) {
    if (coefficients_.empty()) return std::nullopt;
    const auto is_negative = [](const Rational& c) { return c < Rational(0); };
    if (std::any_of(coefficients_.begin(), coefficients_.end(), is_negative)) return std::nullopt;
    std::string first = strict ? "" : "0";
    if (strict) first = take_positive_term();
    if (first.empty()) first = take_constant();
    if (first.empty()) return std::nullopt;
    std::string result = first;
    for (std::size_t index = 0; index < coefficients_.size(); ++index) {
      if (coefficients_[index] != Rational(0)) result += " + " + term(index);
    }
    return "(" + result + ")";
  }

 private:
  [[nodiscard]] std::size_t stride(std::size_t variable) const {
    std::size_t result = 1;
    for (std::size_t at = variable + 1; at < degrees_.size(); ++at) result *= degrees_[at] + 1;
    return result;
  }

  [[nodiscard]] std::vector<std::size_t> exponents(std::size_t index) const {
    std::vector<std::size_t> result(degrees_.size());
    for (std::size_t at = degrees_.size(); at-- > 0;) {
      result[at] = index % (degrees_[at] + 1);
      index /= degrees_[at] + 1;
    }
    return result;
  }

  /// From powers of x to those of x − a, to those of b − x, or to Bernstein's products.
  void change_basis(std::size_t variable) {
    const unsigned long degree = degrees_[variable];
    if (degree == 0) return;
    const std::size_t step = stride(variable);
    for (std::size_t start = 0; start < coefficients_.size(); ++start) {
      if (start / step % (degree + 1) != 0) continue;
      std::vector<Rational> line;
      for (unsigned long i = 0; i <= degree; ++i) line.push_back(coefficients_[start + i * step]);
      line = in_basis(std::move(line), variables_[variable]);
      for (unsigned long i = 0; i <= degree; ++i) coefficients_[start + i * step] = line[i];
    }
  }

  static std::vector<Rational> in_basis(std::vector<Rational> line, const FormalVariable& variable) {
    const std::size_t degree = line.size() - 1;
    const Rational origin = variable.lower ? *variable.lower : *variable.upper;
    for (std::size_t from = 0; from < degree; ++from) {
      for (std::size_t i = degree; i-- > from;) line[i] += origin * line[i + 1];
    }
    if (!variable.lower) {
      for (std::size_t i = 1; i <= degree; i += 2) line[i] = -line[i];
    }
    if (!variable.lower || !variable.upper) return line;
    const Rational width = *variable.upper - *variable.lower;
    if (width == Rational(0)) return line;
    std::vector<Rational> result(line.size());
    for (std::size_t i = 0; i <= degree; ++i) {
      for (std::size_t k = 0; k <= i; ++k) {
        // t^k (t + (1 − t))^(d − k)
        result[i] += line[k] * power(width, static_cast<long>(k)) * binomial(degree - k, i - k);
      }
      result[i] /= power(width, static_cast<long>(degree));
    }
    return result;
  }

  [[nodiscard]] bool is_bounded(std::size_t at) const {
    return variables_[at].lower && variables_[at].upper && *variables_[at].lower != *variables_[at].upper;
  }

  [[nodiscard]] std::string term(std::size_t index) const {
    std::string result = coq_number(coefficients_[index]);
    const std::vector<std::size_t> powers = exponents(index);
    for (std::size_t at = 0; at < powers.size(); ++at) {
      const FormalVariable& variable = variables_[at];
      const std::size_t from_above = is_bounded(at) ? degrees_[at] - powers[at] : 0;
      if (powers[at] > 0) result += " * " + power_text(variable.lower ? above(variable) : below(variable), powers[at]);
      if (from_above > 0) result += " * " + power_text(below(variable), from_above);
    }
    return result;
  }

  /// Whether no factor of the term vanishes in the range.
  [[nodiscard]] bool never_vanishes(std::size_t index) const {
    const std::vector<std::size_t> powers = exponents(index);
    for (std::size_t at = 0; at < powers.size(); ++at) {
      const FormalVariable& variable = variables_[at];
      const bool end_open = variable.lower ? variable.lower_open : variable.upper_open;
      if (powers[at] > 0 && !end_open) return false;
      if (is_bounded(at) && powers[at] < degrees_[at] && !variable.upper_open) return false;
    }
    return true;
  }

  std::string take_positive_term() {
    for (std::size_t index = 0; index < coefficients_.size(); ++index) {
      if (coefficients_[index] == Rational(0) || !never_vanishes(index)) continue;
      std::string result = term(index);
      coefficients_[index] = Rational(0);
      return result;
    }
    return "";
  }

  /// The greatest constant that leaves no coefficient negative.
  std::string take_constant() {
    std::vector<Rational> share(coefficients_.size());
    std::optional<Rational> constant;
    for (std::size_t index = 0; index < coefficients_.size(); ++index) {
      share[index] = Rational(1);
      const std::vector<std::size_t> powers = exponents(index);
      for (std::size_t at = 0; at < powers.size(); ++at) {
        if (is_bounded(at)) {
          share[index] *= binomial(degrees_[at], powers[at]) /
                          power(*variables_[at].upper - *variables_[at].lower, static_cast<long>(degrees_[at]));
        } else if (powers[at] > 0) {
          share[index] = Rational(0);
        }
      }
      if (share[index] == Rational(0)) continue;
      const Rational allowed = coefficients_[index] / share[index];
      constant = constant ? minimum(*constant, allowed) : allowed;
    }
    if (!constant || *constant <= Rational(0)) return "";
    for (std::size_t index = 0; index < coefficients_.size(); ++index) coefficients_[index] -= *constant * share[index];
    return coq_number(*constant);
  }

  const FormalVariables& variables_;
  std::vector<unsigned long> degrees_;
  std::vector<Rational> coefficients_;
};

}  // namespace

std::optional<std::string> bernstein_form(const Polynomial& polynomial, const FormalVariables& variables, bool strict) {
  return Tensor(polynomial, variables).form(strict);
}

}  // namespace delcert
