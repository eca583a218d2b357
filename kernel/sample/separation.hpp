#pragma once

#include "kernel/chart/atlas.hpp"
#include "kernel/chart/label_range.hpp"
#include "support/progress.hpp"

namespace delcert {

/// μ₀, certified: the largest multiple of 2⁻²⁰ that is at most 1 such that no chart i shows another original point, or
/// another lift of its own, closer than μ₀ε_i to p_i. Where transitions are not exact, enclosures of 256 bits decide,
/// and it may be one multiple less. Throws InputError naming the labels of points that coincide, or may be closer than
/// 2⁻²⁰ε_i. Precondition: rounding to nearest.
template <int m>
[[nodiscard]] Rational measure_separation(const Atlas<m>& atlas, const Progress& progress = no_progress());

/// What that takes of some labels: the least squared distance from them, in squares of their sampling radii, or 1 if
/// none is less. Of all labels it is the least of its parts.
template <int m>
[[nodiscard]] Rational squared_separation(const Atlas<m>& atlas, LabelRange labels, const Progress& progress);
/// μ₀, from this.
[[nodiscard]] Rational separation_of(const Rational& squared);

}  // namespace delcert
