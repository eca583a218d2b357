#pragma once

#include <string>

#include "kernel/number/rational.hpp"

namespace delcert {

/// x as an integer or as a fraction in lowest terms, whatever its denominator: what formulas, ranges and logs are
/// written with, which have no hexadecimal numbers.
[[nodiscard]] std::string fraction_text(const Rational& x);

}  // namespace delcert
