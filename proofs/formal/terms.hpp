#pragma once

#include <string>
#include <vector>

#include "kernel/formula/expression.hpp"

namespace delcert {

/// The node with other children.
[[nodiscard]] ExpressionPointer with_children(const ExpressionPointer& node, std::vector<ExpressionPointer> children);

/// A name, a number that is not negative, a sum or a quotient and so on, and a power that is an integer.
[[nodiscard]] ExpressionPointer name_term(const std::string& name);
[[nodiscard]] ExpressionPointer number_term(const Rational& value);
[[nodiscard]] ExpressionPointer binary_term(Operation operation, ExpressionPointer a, ExpressionPointer b);
[[nodiscard]] ExpressionPointer power_term(ExpressionPointer base, long exponent);

}  // namespace delcert
