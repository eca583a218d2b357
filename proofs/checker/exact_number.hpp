#pragma once

#include <string_view>

#include "proofs/checker/rational.hpp"

namespace delcert::checker {

/// Whether the text is an integer, a fraction with denominator other than 0, or a hexadecimal float with at most 5
/// digits of exponent, as "Exact numbers" of the format says.
bool is_exact_number(std::string_view text);

/// The value, without rounding. Precondition: is_exact_number(text).
Rational exact_value(std::string_view text);

/// An enclosure of relative width at most 2^-50, much faster than through `exact_value`.
/// Preconditions: is_exact_number(text), the thread rounds upwards.
Interval enclosure(std::string_view text);

}  // namespace delcert::checker
