#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proofs/formal/formal_parameters.hpp"

namespace delcert {

/// Powers with exponents that are not constant, written with powers that can be variables of a polynomial.
///
/// With m = 1 + m′ and m′ >= 0, g^(2m + 1) is g^3·(g^m′)^2; for g in (0, 1] the power g^m′ runs through (0, 1], for
/// g >= 1 through [1, infinity). Bases are products and quotients of parameters and numbers.
class SymbolicPowers {
 public:
  explicit SymbolicPowers(const FormalParameters& parameters);

  /// The term with each such power replaced; nothing if one cannot be.
  [[nodiscard]] std::optional<ExpressionPointer> replaced(const ExpressionPointer& term);

  /// The new variables, by name, with what is known of them.
  [[nodiscard]] const std::vector<FormalVariable>& variables() const { return variables_; }
  /// The tactics that introduce them and rewrite the goal.
  [[nodiscard]] std::string script() const;

 private:
  struct Part {
    std::string text;  ///< of a base: a parameter or a number
    ExpressionPointer term;
    long exponent = 1;
    bool above_one = false;
  };
  struct Monomial {
    Rational coefficient;
    std::string text;  ///< empty for 1
  };
  [[nodiscard]] std::optional<std::vector<Part>> parts(const ExpressionPointer& base) const;
  [[nodiscard]] std::optional<std::vector<Monomial>> monomials(const Expression& exponent) const;
  [[nodiscard]] std::string variable(const Part& part, const std::string& exponent);
  [[nodiscard]] std::optional<ExpressionPointer> replaced_power(const ExpressionPointer& term);

  const FormalParameters& parameters_;
  RingPointer ring_;
  std::map<std::string, std::string> known_;  ///< what power a variable is → its name
  std::vector<FormalVariable> variables_;
  std::string introductions_;
  std::vector<std::string> facts_;
};

}  // namespace delcert
