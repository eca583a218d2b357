#pragma once

#include <string>

#include "kernel/number/rational.hpp"

namespace delcert {

/// x exactly, for LaTeX's mathematical mode: an integer, p/q, or n · 2⁻ᵏ where the exact text is a hexadecimal float.
/// Long numbers can be broken between digits.
[[nodiscard]] std::string exact_latex(const Rational& x);

/// A decimal of `decimal_lower` or `decimal_upper` for the same mode: 2.5e-7 is 2.5 · 10⁻⁷.
[[nodiscard]] std::string decimal_latex(const std::string& decimal);

}  // namespace delcert
