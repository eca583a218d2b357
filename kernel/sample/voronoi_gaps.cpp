#include "kernel/sample/voronoi_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/delaunay/approximate_delaunay.hpp"
#include "kernel/delaunay/approximate_sphere.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert {

namespace {

/// More than the slack of the grids that points are inserted in, so that they can be.
constexpr double clearance = 1 + 0x1p-28;
/// Of the room about the centre of a gap, for roundings and for the stretching of conformal coordinates.
constexpr double used_room = 0.9;

double midpoint(const Interval& x) { return x.lower() / 2 + x.upper() / 2; }

}  // namespace

template <int m>
VoronoiGaps<m>::VoronoiGaps(Curvature curvature, double radius)
    : curvature_(curvature), least_tangent_(tangent(radius * clearance)), most_tangent_(tangent(radius * reach / 2)) {
  for (std::size_t axis = 0; axis < m; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vector<double, m> post{};
      post[axis] = side * 2 * most_tangent_;
      fence_.push_back(post);
    }
  }
}

template <int m>
double VoronoiGaps<m>::tangent(double length) const {
  const RoundingGuard guard;
  const Interval x = Interval::exactly(length);
  return midpoint(x * sine_ratio(curvature_, square(x)) / cosine_of_root(curvature_, square(x)));
}

template <int m>
double VoronoiGaps<m>::length_of_tangent(double tangent) const {
  const RoundingGuard guard;
  const Interval x = Interval::exactly(tangent);
  return midpoint(x * arctangent_ratio(curvature_, square(x)));
}

template <int m>
Vector<double, m> VoronoiGaps<m>::point_towards(const Vector<double, m>& centre, double gap,
                                                CounterRandom& random) const {
  // tan(R/2) = tan R/(1 + √(1 + tan² R)), and the tangent of the difference of the gap's radius and the net's.
  const double sign = sign_of(curvature_);
  const double cut = std::min(gap, most_tangent_);
  const double distance = 2 * cut / (1 + std::sqrt(1 + sign * cut * cut));
  const double room = std::max(0.0, used_room * (cut - least_tangent_) / (1 + sign * cut * least_tangent_));
  Vector<double, m> offset;
  do {
    for (double& coordinate : offset) coordinate = 2 * random.next_unit() - 1;
  } while (pairing(offset, offset) > 1);
  Vector<double, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = centre[axis] / gap * distance + offset[axis] * room;
  return result;
}

template <int m>
typename VoronoiGaps<m>::Found VoronoiGaps<m>::find(const std::vector<Vector<double, m>>& others,
                                                    CounterRandom& random) const {
  Found found;
  // A ball through the point with tangent ρ reaches to 2ρ.
  std::vector<Vector<double, m>> points{Vector<double, m>{}};
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& other : others) {
    points.push_back(other);
    nearest = std::min(nearest, std::sqrt(pairing(other, other)));
  }
  // |a| = 2 tan(d/2).
  if (!others.empty()) found.nearest = 2 * length_of_tangent(nearest / 2);
  points.insert(points.end(), fence_.begin(), fence_.end());
  static const auto metric = FrameMetric<m>::cartesian().template on<PlainDouble>();
  double farthest = 0;
  for (const auto& simplex : approximate_delaunay<m>(points)) {
    if (simplex[0] != 0) continue;
    std::array<Vector<double, m>, static_cast<std::size_t>(m) + 1> vertices;
    for (std::size_t corner = 0; corner <= m; ++corner) vertices[corner] = points[simplex[corner]];
    const auto sphere = approximate_sphere<m>(metric, vertices);
    const double gap = std::sqrt(sphere.squared_radius);
    if (!std::isfinite(gap)) continue;
    farthest = std::max(farthest, gap);
    if (gap > least_tangent_) found.points.push_back(point_towards(sphere.centre, gap, random));
  }
  found.farthest_vertex = length_of_tangent(std::min(farthest, most_tangent_));
  return found;
}

template class VoronoiGaps<2>;
template class VoronoiGaps<3>;

}  // namespace delcert
