#pragma once

#include <optional>

#include "kernel/manifold/gluing/metric_field_atlas.hpp"
#include "support/progress.hpp"

namespace delcert {

/// Certified upper bounds of what charts make of each other and of the metric (docs/metric-fields.md).
struct ChartDistortion {
  /// η: (1 − η) G(p_i) < B_i < (1 + η) G(p_i).
  Rational rounding;
  /// ξ₀: |s − 1| ≤ ξ₀ for the singular values s of every A_j A_i⁻¹ where p_j is in the patch of i; 0 where all charts
  /// have the same matrix.
  Rational transition;
  /// κ: (1 − κ)² B_i < G(x) < (1 + κ)² B_i for all x of the patch of i.
  Rational metric;
};

/// Measures them, a little too large: by at most 1/32 of themselves, but for what boxes add to κ. None if one of them
/// is not certainly below the limit. Precondition: rounding to nearest; limit ≤ 1/2.
template <int m>
[[nodiscard]] std::optional<ChartDistortion> measure_distortion(const MetricFieldAtlas<m>& atlas, const Rational& limit,
                                                                const Progress& progress);

/// Makes the patches of the atlas smaller until nothing is distorted by 1/4 or more in them, or they are as small as
/// they can be, and measures that. Throws Rejection if they are still distorted by 1/2 or more: the radius is too large
/// for the metric.
template <int m>
[[nodiscard]] ChartDistortion fit_patches(MetricFieldAtlas<m>& atlas, const Progress& progress);

/// An upper bound of how much longer than in the chart of its own label a vector is in the chart of i, relative, where
/// the patch of i holds the original or the perturbed point: (1 + κ)/(1 − κ) − 1 (docs/metric-fields.md).
[[nodiscard]] Rational relative_stretch(const ChartDistortion& distortion);

}  // namespace delcert
