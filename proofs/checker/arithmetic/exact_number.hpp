#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "proofs/checker/arithmetic/rational.hpp"

namespace delcert::checker {

/// Whether the text is an integer, a fraction with denominator other than 0, or a hexadecimal float with at most 5
/// digits of exponent, as "Exact numbers" of the format says.
bool is_exact_number(std::string_view text);

/// How long the exact number is with which the text begins, the longest there is; 0 if there is none.
std::size_t exact_number_length(std::string_view text);

/// The value, without rounding. Precondition: is_exact_number(text).
Rational exact_value(std::string_view text);

/// An enclosure with relative width at most 2^-52, and no width where the number is a double, if it is an integer times
/// a power of 2 so written that this can be read off.
std::optional<Interval> read_enclosure(std::string_view text);
/// The same of several; the whole line where that cannot be read off.
std::vector<Interval> read_enclosures(const std::vector<std::string_view>& texts);

}  // namespace delcert::checker
