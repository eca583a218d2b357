#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert::checker_tests {

/// The value of a formula of whole numbers, variables, + - * / ^ abs() and parentheses at a rational point; none where
/// a divisor is 0. Throws std::invalid_argument of what is no such formula. By the text alone, with no other reader of
/// formulas.
std::optional<Rational> exact_value(const std::string& formula, const std::vector<std::string>& variables,
                                    const std::vector<Rational>& point);

}  // namespace delcert::checker_tests
