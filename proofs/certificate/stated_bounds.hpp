#pragma once

#include "kernel/number/rational.hpp"

namespace delcert {

// Certificates state bounds of few binary digits, weaker than what was found by a relative 2⁻²⁰ at least: a reader with
// other enclosures finds them too.

constexpr long digits_of_lengths = 12;
constexpr long digits_of_stretches = 30;

/// The number with this many binary digits next below x(1 − 2⁻²⁰). Precondition: x > 0.
[[nodiscard]] Rational stated_below(const Rational& x, long digits = digits_of_lengths);
[[nodiscard]] Rational stated_below(double x, long digits = digits_of_lengths);
/// Next above x(1 + 2⁻²⁰). Precondition: x > 0.
[[nodiscard]] Rational stated_above(const Rational& x, long digits = digits_of_lengths);
[[nodiscard]] Rational stated_above(double x, long digits = digits_of_lengths);

}  // namespace delcert
