#include "proofs/formal/domination.hpp"

#include <algorithm>

#include "proofs/formula/coq.hpp"

namespace delcert {

namespace {

enum class Kind : unsigned char { unit, above_one, other };

/// A variable that is scaled so that its range ends or begins at 1.
struct Scaled {
  std::string text;
  Rational scale = Rational(1);
  Kind kind = Kind::other;
  bool is_nonnegative = false;
  bool is_positive = false;
};

Scaled scaled(const FormalVariable& variable) {
  Scaled result{variable.text, Rational(1), Kind::other, variable.is_nonnegative(), variable.is_positive()};
  if (!variable.is_nonnegative()) return result;
  if (variable.upper && *variable.upper > Rational(0)) {
    result.kind = Kind::unit;
    result.scale = *variable.upper;
  } else if (*variable.lower > Rational(0)) {
    result.kind = Kind::above_one;
    result.scale = *variable.lower;
  }
  if (result.scale != Rational(1)) {
    result.text = "(" + coq_number(Rational(1) / result.scale) + " * " + variable.text + ")";
  }
  return result;
}

struct Monomial {
  Rational weight;
  std::vector<unsigned long> exponents;
};

class Matching {
 public:
  Matching(const Polynomial& polynomial, const FormalVariables& variables) {
    for (const FormalVariable& variable : variables) variables_.push_back(scaled(variable));
    for (const auto& [coefficient, exponents] : polynomial.terms()) {
      Rational weight = coefficient;
      for (std::size_t at = 0; at < exponents.size(); ++at) {
        if (exponents[at] == 0) continue;
        if (!variables_[at].is_nonnegative) possible_ = false;
        weight *= power(variables_[at].scale, static_cast<long>(exponents[at]));
      }
      (weight < Rational(0) ? negative_ : positive_).push_back({absolute(weight), exponents});
    }
  }

  std::optional<std::string> form(bool strict) {
    if (!possible_) return std::nullopt;
    match();
    const bool matched =
        std::all_of(negative_.begin(), negative_.end(), [](const Monomial& one) { return one.weight == Rational(0); });
    if (!matched) return std::nullopt;
    // What is left over; a term that is not 0 anywhere comes first.
    std::string first;
    std::string rest;
    for (const Monomial& one : positive_) {
      if (one.weight == Rational(0)) continue;
      const std::string text = coq_number(one.weight) + product(one.exponents, one.exponents);
      if (first.empty() && is_positive(one)) {
        first = text;
      } else {
        rest += " + " + text;
      }
    }
    if (strict && first.empty()) return std::nullopt;
    const std::string sum = (first.empty() ? "0" : first) + rest + pairs_;
    return "(" + sum + ")";
  }

 private:
  [[nodiscard]] bool dominates(const Monomial& large, const Monomial& small) const {
    for (std::size_t at = 0; at < variables_.size(); ++at) {
      if (large.exponents[at] == small.exponents[at]) continue;
      const Kind kind = variables_[at].kind;
      if (kind == Kind::other) return false;
      if ((kind == Kind::unit) == (large.exponents[at] > small.exponents[at])) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_positive(const Monomial& one) const {
    for (std::size_t at = 0; at < variables_.size(); ++at) {
      if (one.exponents[at] > 0 && !variables_[at].is_positive) return false;
    }
    return true;
  }

  /// " * x ^ 2 * y", with the variables that occur in one of the two.
  [[nodiscard]] std::string product(const std::vector<unsigned long>& exponents,
                                    const std::vector<unsigned long>& others) const {
    std::string result;
    for (std::size_t at = 0; at < variables_.size(); ++at) {
      if (exponents[at] == 0 && others[at] == 0) continue;
      result += " * " + variables_[at].text + " ^ " + std::to_string(exponents[at]);
    }
    return result;
  }

  /// First the negative terms with the fewest that dominate them.
  void match() {
    const auto choices = [this](const Monomial& one) {
      return std::count_if(positive_.begin(), positive_.end(),
                           [&](const Monomial& large) { return dominates(large, one); });
    };
    std::stable_sort(negative_.begin(), negative_.end(),
                     [&](const Monomial& a, const Monomial& b) { return choices(a) < choices(b); });
    std::vector<Monomial*> order;
    for (Monomial& large : positive_) order.push_back(&large);
    for (Monomial& small : negative_) {
      // First the positive terms that can serve the fewest.
      const auto uses = [this](const Monomial& large) {
        return std::count_if(negative_.begin(), negative_.end(),
                             [&](const Monomial& one) { return one.weight > Rational(0) && dominates(large, one); });
      };
      std::stable_sort(order.begin(), order.end(),
                       [&](const Monomial* a, const Monomial* b) { return uses(*a) < uses(*b); });
      for (Monomial* large : order) {
        const Rational weight = minimum(large->weight, small.weight);
        if (weight == Rational(0) || !dominates(*large, small)) continue;
        large->weight -= weight;
        small.weight -= weight;
        pairs_ += " + " + coq_number(weight) + " * (" + product(large->exponents, small.exponents).substr(3) + " - " +
                  product(small.exponents, large->exponents).substr(3) + ")";
      }
    }
  }

  std::vector<Scaled> variables_;
  std::vector<Monomial> positive_;
  std::vector<Monomial> negative_;
  std::string pairs_;
  bool possible_ = true;
};

}  // namespace

std::optional<std::string> domination(const Polynomial& polynomial, const FormalVariables& variables, bool strict) {
  return Matching(polynomial, variables).form(strict);
}

}  // namespace delcert
