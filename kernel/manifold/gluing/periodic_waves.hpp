#pragma once

#include "kernel/chart/curved_functions.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

/// cos 2πt and sin 2πt.
template <class S>
struct Wave {
  S cosine;
  S sine;
};

/// Enclosures for an exactly known t of any size, on both rungs that have them: t is reduced exactly, so that they are
/// as tight for large t. At multiples of 1/4 exact. On `Interval` needs a `RoundingGuard`; no function of `libm` is
/// called.
template <class S>
[[nodiscard]] Wave<S> wave_at(const Rational& t);

/// Enclosures of all values for the t with |t − middle| ≤ half_width, of first order in half_width, and in [−1, 1].
/// Needs a `RoundingGuard`. Precondition: half_width ≥ 0.
[[nodiscard]] Wave<Interval> wave_within(const Rational& middle, const Rational& half_width);

}  // namespace delcert
