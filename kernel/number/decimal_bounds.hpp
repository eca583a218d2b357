#pragma once

#include <string>

#include "kernel/number/rational.hpp"

namespace delcert {

/// The largest decimal number of `digits` significant digits that is not above x, for display: "0.25", "6.2803e-16".
/// Equal to x where x has so few digits. Precondition: digits >= 1.
[[nodiscard]] std::string decimal_lower(const Rational& x, int digits);
/// The smallest one that is not below x.
[[nodiscard]] std::string decimal_upper(const Rational& x, int digits);

}  // namespace delcert
