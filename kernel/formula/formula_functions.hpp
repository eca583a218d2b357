#pragma once

#include <concepts>

#include "kernel/number/elementary.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

// The functions of formulas on the rungs. On `Interval` they need a `RoundingGuard`, return an enclosure of the values
// on the argument, and call no function of `libm`. On double they return a number next to the value, the same
// everywhere.

[[nodiscard]] Interval exponential(const Interval& x);
[[nodiscard]] Interval sine(const Interval& x);
[[nodiscard]] Interval cosine(const Interval& x);
[[nodiscard]] double approximate_exponential(double x);
[[nodiscard]] double approximate_sine(double x);
[[nodiscard]] double approximate_cosine(double x);

/// x to a power ≥ 1; of an interval the powers of its elements, and no more: ≥ 0 for even exponents.
[[nodiscard]] double whole_power(double x, unsigned exponent);
[[nodiscard]] Interval whole_power(const Interval& x, unsigned exponent);
[[nodiscard]] BigInterval whole_power(const BigInterval& x, unsigned exponent);

}  // namespace delcert
