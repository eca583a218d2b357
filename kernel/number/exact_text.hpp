#pragma once

#include <string>
#include <string_view>

#include "kernel/number/rational.hpp"

namespace delcert {

/// The exact text of x, as docs/certificate-format.md says: an integer, a fraction p/q, or a hexadecimal float.
[[nodiscard]] std::string exact_text(const Rational& x);

/// Reads any of the three forms. Throws ExactTextError that says what was expected and where; a decimal point is
/// refused with the hint to write a fraction.
[[nodiscard]] Rational parse_exact(std::string_view text);

}  // namespace delcert
