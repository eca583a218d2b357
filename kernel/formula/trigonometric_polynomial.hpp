#pragma once

#include <map>
#include <string>
#include <vector>

#include "kernel/formula/expression.hpp"

namespace delcert {

/// Σ a_k cos(k·u) + b_k sin(k·u) over integer vectors k, with rational coefficients, exact.
class TrigonometricPolynomial {
 public:
  struct Wave {
    Rational cosine{};
    Rational sine{};
  };
  /// Of k and −k the one of which the first entry that is not 0 is positive; no wave is 0.
  using Waves = std::map<std::vector<int>, Wave>;

  /// A constant, in so many variables.
  explicit TrigonometricPolynomial(std::size_t variables, const Rational& constant = Rational(0));
  /// cos(k·u) and sin(k·u).
  [[nodiscard]] static TrigonometricPolynomial cosine(const std::vector<int>& frequency);
  [[nodiscard]] static TrigonometricPolynomial sine(const std::vector<int>& frequency);

  [[nodiscard]] const Waves& waves() const { return waves_; }
  [[nodiscard]] TrigonometricPolynomial derivative(std::size_t variable) const;

  // Precondition: as many variables.
  friend TrigonometricPolynomial operator+(TrigonometricPolynomial a, const TrigonometricPolynomial& b);
  friend TrigonometricPolynomial operator*(const TrigonometricPolynomial& a, const TrigonometricPolynomial& b);

 private:
  void add(std::vector<int> frequency, Wave wave);

  std::size_t variables_;
  Waves waves_;
};

/// What a formula is, of + − *, whole powers, division by numbers, and sin and cos of sums of variables times integers.
/// Throws FormulaError, with the place, for one that is no trigonometric polynomial in these variables, or one of more
/// than 1000 waves.
[[nodiscard]] TrigonometricPolynomial trigonometric_polynomial_of(const Expression& formula,
                                                                  const std::vector<std::string>& variables);

}  // namespace delcert
