#pragma once

#include "kernel/manifold/gluing/metric_field_atlas.hpp"

namespace delcert {

/// μ₀, certified: a multiple of 2⁻²⁰, at most 1, such that no chart shows another original point closer than μ₀ε to its
/// own; no larger multiple is. Throws InputError naming the labels of points closer than 2⁻²⁰ε, or the same.
template <int m>
[[nodiscard]] Rational measure_separation(const MetricFieldAtlas<m>& atlas);

}  // namespace delcert
