#pragma once

#include <cstdint>

#include "kernel/manifold/submanifold/cover_check.hpp"
#include "kernel/manifold/submanifold/submanifold_atlas.hpp"

namespace delcert {

template <int m>
struct SubmanifoldNet {
  /// Centres of charts, in the order of a space-filling curve: points near M, dyadic.
  std::vector<std::vector<Rational>> centres;
  /// Charts about them, which have passed.
  FittedCharts charts;
  /// In doubles, without error bounds: the greatest distance of a Voronoi vertex from its point, in the charts.
  double covering_radius = 0;
  std::uint64_t parts = 0;  ///< of the box, when it was shown to be covered
};

/// A maximal Poisson-disk set of a zero set, each distance measured in the tangent plane at a point, as in
/// `metric_field_net`; darts are random points of the box, taken to M by Newton's method. Where parts of the box remain
/// that no chart covers (`check_cover`), new points are tried from there: so components that no dart has hit are found.
/// The same for a seed everywhere.
///
/// The points are made in doubles; charts and cover are certified. Throws Rejection if there are more than 2 000 000
/// points, M is certainly empty, or charts do not fit (`fit_charts`); Undecided, with its corners, if a part of the box
/// remains from which no new point is found. Precondition: the zero set has dimension m; rounding to nearest.
template <int m>
[[nodiscard]] SubmanifoldNet<m> submanifold_net(const ZeroSet& zero_set, const Rational& radius, std::uint64_t seed,
                                                const Progress& progress);

/// Throws Undecided, with the corners of a part, unless the charts cover the zero set (`check_cover`). Returns the
/// number of parts.
std::uint64_t require_cover(const ZeroSet& zero_set, const std::vector<TangentChart>& charts, const Progress& progress);

}  // namespace delcert
