#pragma once

#include <cstdint>
#include <vector>

#include "kernel/manifold/gluing/formula_atlas.hpp"
#include "support/progress.hpp"

namespace delcert {

template <int m>
struct AtlasNet {
  /// Coordinates are multiples of 2⁻⁴⁸ and doubles; chart by chart, in each in the order of a space-filling curve.
  std::vector<NetPlace<m>> places;
  /// In doubles, without error bounds: the greatest distance of a Voronoi vertex from its point, in the charts.
  double covering_radius = 0;
};

/// A maximal Poisson-disk set of glued charts, each distance measured in the affine chart of a point by `GluingMetric`,
/// as `metric_field_net` does it; each point in the chart in which it lies deepest. The same for a seed everywhere.
///
/// Made in doubles: what comes out is to be measured, not believed. Throws InputError for a radius ≤ 0, and Rejection
/// when there would be more than 2 000 000 points.
template <int m>
[[nodiscard]] AtlasNet<m> atlas_net(const ChartGluing& gluing, const Rational& radius, std::uint64_t seed,
                                    const Progress& progress);

}  // namespace delcert
