#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/formula/polynomial.hpp"

namespace delcert {

/// A variable of a polynomial as a term of Coq, and the range that is known of it there: for each end that is given a
/// hypothesis says lower <= text (or <, if it is open).
struct FormalVariable {
  std::string text;
  std::optional<Rational> lower;
  std::optional<Rational> upper;
  bool lower_open = false;
  bool upper_open = false;

  [[nodiscard]] bool is_nonnegative() const { return lower && *lower >= Rational(0); }
  [[nodiscard]] bool is_positive() const {
    return lower && (*lower > Rational(0) || (*lower == Rational(0) && lower_open));
  }
};

/// The variables of a ring, in its order.
using FormalVariables = std::vector<FormalVariable>;

/// base ^ exponent, for a base that needs no parentheses.
[[nodiscard]] std::string power_text(const std::string& base, unsigned long exponent);

/// A polynomial as a term of Coq, in parentheses unless it is a name or a number.
[[nodiscard]] std::string polynomial_text(const Polynomial& polynomial, const FormalVariables& variables);

}  // namespace delcert
