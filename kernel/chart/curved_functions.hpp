#pragma once

#include <concepts>

#include "kernel/number/elementary.hpp"

namespace delcert {

/// The constant sectional curvature of a model space: 𝕊ᵐ, 𝔼ᵐ or ℍᵐ.
enum class Curvature : signed char { negative = -1, zero = 0, positive = 1 };

[[nodiscard]] constexpr int sign_of(Curvature curvature) { return static_cast<int>(curvature); }

// The functions of a length d that the model spaces need, written as functions of its square s = d² ≥ 0 or of q, the
// square of tan(d/2), d/2 or tanh(d/2): analytic at 0, so nothing cancels for small lengths.
//
// Every one returns an enclosure of its values on the argument, of which negative parts are cut off (the exact
// argument is known not to be negative). On `Interval` they need a `RoundingGuard`, and call no function of `libm`:
// power series with a bound of the remainder, or the other rung where those converge too slowly.

/// cos √s, 1, cosh √s. For positive curvature: [−1, 1] where s may be π² or more.
[[nodiscard]] Interval cosine_of_root(Curvature curvature, const Interval& s);
[[nodiscard]] BigInterval cosine_of_root(Curvature curvature, const BigInterval& s);

/// sin √s / √s, 1, sinh √s / √s; 1 at s = 0. For positive curvature: [−1, 1] where s may be π² or more.
[[nodiscard]] Interval sine_ratio(Curvature curvature, const Interval& s);
[[nodiscard]] BigInterval sine_ratio(Curvature curvature, const BigInterval& s);

/// arctan √q / √q, 1, artanh √q / √q; 1 at q = 0. For negative curvature unbounded where q may be 1 or more.
[[nodiscard]] Interval arctangent_ratio(Curvature curvature, const Interval& q);
[[nodiscard]] BigInterval arctangent_ratio(Curvature curvature, const BigInterval& q);

/// π on a rung of the ladder.
template <class S>
[[nodiscard]] S straight_angle() {
  if constexpr (std::same_as<S, Interval>) {
    static const Interval enclosure = in_doubles(half_turn());
    return enclosure;
  } else {
    return half_turn();
  }
}

}  // namespace delcert
