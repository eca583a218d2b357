#pragma once

#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "support/progress.hpp"

namespace delcert {

/// μ₀, certified: a multiple of 2⁻²⁰, at most 1, such that pairwise distances in X/Γ are at least μ₀ε; no larger
/// multiple is, but where enclosures of 256 bits do not tell. By the lengths of what charts show, which are the
/// distances from their centres. Throws InputError naming the labels of points that coincide, or may be closer than
/// 2⁻²⁰ε. Precondition: rounding to nearest.
template <int m>
[[nodiscard]] Rational measure_separation(const SpaceFormAtlas<m>& atlas, const Progress& progress = no_progress());

}  // namespace delcert
