#pragma once

#include <cstdint>

#include "kernel/manifold/gluing/metric_field_atlas.hpp"
#include "support/progress.hpp"

namespace delcert {

template <int m>
struct MetricFieldNet {
  /// Coordinates in [0, 1), multiples of 2⁻⁴⁸ and doubles, in the order of a space-filling curve.
  std::vector<Vector<Rational, m>> centres;
  /// In doubles, without error bounds: the greatest distance of a Voronoi vertex from its point, in the charts.
  double covering_radius = 0;
};

/// A maximal Poisson-disk set of a metric field, each distance measured in the chart of a point: no point was taken
/// that is closer than `radius` to another in the chart at hand, and in every chart the Voronoi cell of its point lies
/// within radius·(1 + 2⁻²⁷). Darts, then a random point near every vertex of a Voronoi cell that is farther than the
/// radius from its point, chart by chart, until there is none. The same for a seed everywhere.
///
/// Made in doubles: what comes out is to be measured, not believed. Throws Rejection when there would be more than
/// 2 000 000 points, or the radius is not below √λ/8, λ the least eigenvalue of the metric: too large for any patch.
template <int m>
[[nodiscard]] MetricFieldNet<m> metric_field_net(const MetricField<m>& field, const Rational& radius,
                                                 std::uint64_t seed, const Progress& progress);

}  // namespace delcert
