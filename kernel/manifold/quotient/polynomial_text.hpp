#pragma once

#include <string_view>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// The coefficients of a polynomial in t, constant first, from signed terms such as "3/4", "t", "2*t" or "-1/2*t^3";
/// blanks may stand around signs. A power may occur only once, exponents are below 1000. Throws InputError that says
/// where the text goes wrong.
[[nodiscard]] std::vector<Rational> parse_polynomial(std::string_view text);

}  // namespace delcert
