#pragma once

#include <optional>

#include "kernel/formula/expression.hpp"
#include "kernel/number/rational.hpp"

namespace delcert {

/// The number that stands in a formula where the pattern has the name C: 42 for "a <= 42*b" and the pattern "a <= C*b".
/// Numbers in a product count together, wherever they stand: in "99/100*(5/2*b)/4" there is C = 99/160. Other factors
/// have to stand in the same order. Empty if the formula is not of the pattern's form. Precondition: C occurs once in
/// the pattern, and not below a line.
[[nodiscard]] std::optional<Rational> constant_in(const Expression& formula, const Expression& pattern);

/// The value of an expression of integers, + − · / and powers with integer exponents of at most 1000; empty if it is
/// not one, or divides by 0.
[[nodiscard]] std::optional<Rational> constant_value(const Expression& expression);

}  // namespace delcert
