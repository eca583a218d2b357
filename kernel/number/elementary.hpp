#pragma once

#include "kernel/number/big_interval.hpp"
#include "kernel/number/interval.hpp"

namespace delcert {

/// The elementary functions on `BigInterval`, by MPFI: every one returns an enclosure of its values on the argument, at
/// the working precision. No function of `libm` is called.

/// π.
[[nodiscard]] BigInterval half_turn();
[[nodiscard]] BigInterval natural_logarithm_of_two();
[[nodiscard]] BigInterval exponential(const BigInterval& x);
[[nodiscard]] BigInterval sine(const BigInterval& x);
[[nodiscard]] BigInterval cosine(const BigInterval& x);
[[nodiscard]] BigInterval hyperbolic_sine(const BigInterval& x);
[[nodiscard]] BigInterval hyperbolic_cosine(const BigInterval& x);
[[nodiscard]] BigInterval arctangent(const BigInterval& x);
/// artanh x. The whole line unless −1 < x < 1 on all of the argument.
[[nodiscard]] BigInterval area_tangent(const BigInterval& x);
/// arccos x. Parts of the argument outside [−1, 1] are cut off (the exact argument is known to be inside).
[[nodiscard]] BigInterval arccosine(const BigInterval& x);
/// arcosh x. Parts of the argument below 1 are cut off (the exact argument is known not to be below).
[[nodiscard]] BigInterval area_cosine(const BigInterval& x);

/// The ends of an interval as intervals of their own; they may be infinite.
[[nodiscard]] BigInterval lower_end(const BigInterval& x);
[[nodiscard]] BigInterval upper_end(const BigInterval& x);
/// The least interval that contains both.
[[nodiscard]] BigInterval hull(const BigInterval& a, const BigInterval& b);

/// The tightest interval of doubles that contains x. Needs no guard, and one that is alive does no harm.
[[nodiscard]] Interval in_doubles(const BigInterval& x);
/// The same interval with big endpoints, which may be infinite: exact if the working precision is at least 53 bits.
[[nodiscard]] BigInterval in_big(const Interval& x);

}  // namespace delcert
