#include "kernel/sample/voronoi_cells.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/stars/approximate_sphere.hpp"
#include "kernel/stars/approximate_star.hpp"

namespace delcert {

namespace {

/// More than the slack of the grids that points are inserted in, so that they can be.
constexpr double cell_clearance = 1 + 0x1p-28;
/// Of the room about the centre of a gap, for roundings and for the stretching of conformal coordinates.
constexpr double used_room = 0.9;

/// det of these vectors.
template <std::size_t m>
double determinant_of(const std::array<std::array<double, m>, m>& x) {
  if constexpr (m == 1) {
    return x[0][0];
  } else if constexpr (m == 2) {
    return x[0][0] * x[1][1] - x[0][1] * x[1][0];
  } else {
    return pairing(wedge<double, m>({{x[1], x[2], {}}}), x[0]);
  }
}

template <int m>
const MetricOn<PlainDouble, m>& cartesian() {
  static const auto metric = FrameMetric<m>::cartesian().template on<PlainDouble>();
  return metric;
}

/// The part of the cell of 0 in its simplex with the others: volume (times m!) and moment, over the flags of faces,
/// each with the circumcentres of its faces for corners. Parts outside of the simplex count negative where the
/// neighbour's part covers them again.
template <int m>
void add_flags(std::array<Vector<double, m>, static_cast<std::size_t>(m)> others, double& volume,
               Vector<double, m>& moment) {
  std::sort(others.begin(), others.end());
  do {
    Matrix<double, m> corners;
    std::vector<Vector<double, m>> face{Vector<double, m>{}};
    for (std::size_t at = 0; at < m; ++at) {
      face.push_back(others[at]);
      corners[at] = approximate_sphere<m>(cartesian<m>(), face).centre;
    }
    const double part = determinant_of(corners) * (determinant_of(others) > 0 ? 1 : -1);
    volume += part;
    for (const auto& corner : corners) moment = sum(moment, scaled(part / (m + 1), corner));
  } while (std::next_permutation(others.begin(), others.end()));
}

}  // namespace

template <int m>
VoronoiCells<m>::VoronoiCells(Curvature curvature, double reach)
    : curvature_(curvature), most_tangent_(tangent(reach / 2)) {
  // A ball through 0 with the tangent ρ reaches to 2ρ.
  for (std::size_t axis = 0; axis < m; ++axis) {
    for (const double side : {-2.0, 2.0}) {
      Vector<double, m> post{};
      post[axis] = side * most_tangent_;
      fence_.push_back(post);
    }
  }
}

// An end of the enclosure, not its middle: whether a sum next to the end of a guard is rounded upwards depends on the
// compiler.

template <int m>
double VoronoiCells<m>::tangent(double length) const {
  const RoundingGuard guard;
  const Interval x = Interval::exactly(length);
  return (x * sine_ratio(curvature_, square(x)) / cosine_of_root(curvature_, square(x))).lower();
}

template <int m>
double VoronoiCells<m>::length_of_tangent(double tangent) const {
  const RoundingGuard guard;
  const Interval x = Interval::exactly(tangent);
  return (x * arctangent_ratio(curvature_, square(x))).lower();
}

template <int m>
Vector<double, m> VoronoiCells<m>::conformal_centre(const Vector<double, m>& sphere_centre) const {
  // tan(R/2) = tan R/(1 + √(1 + tan² R)).
  const double gap = std::sqrt(pairing(sphere_centre, sphere_centre));
  const double cut = std::min(gap, most_tangent_);
  const double distance = 2 * cut / (1 + std::sqrt(1 + sign_of(curvature_) * cut * cut));
  return scaled(distance / gap, sphere_centre);
}

template <int m>
std::vector<Vector<double, m>> VoronoiCells<m>::points_in_gaps(const Cell& cell, double radius,
                                                               CounterRandom& random) const {
  std::vector<Vector<double, m>> result;
  const double least = tangent(radius * cell_clearance);
  for (const auto& centre : cell.sphere_centres) {
    const double cut = std::min(std::sqrt(pairing(centre, centre)), most_tangent_);
    if (cut <= least) continue;
    // The tangent of the difference of the gap's radius and the net's.
    const double room = used_room * (cut - least) / (1 + sign_of(curvature_) * cut * least);
    Vector<double, m> offset;
    do {
      for (double& coordinate : offset) coordinate = 2 * random.next_unit() - 1;
    } while (pairing(offset, offset) > 1);
    result.push_back(sum(conformal_centre(centre), scaled(room, offset)));
  }
  return result;
}

template <int m>
typename VoronoiCells<m>::Cell VoronoiCells<m>::cell(const std::vector<Vector<double, m>>& others) const {
  Cell result;
  std::vector<Vector<double, m>> points{Vector<double, m>{}};
  points.insert(points.end(), others.begin(), others.end());
  const std::size_t first_post = points.size();
  points.insert(points.end(), fence_.begin(), fence_.end());
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& other : others) nearest = std::min(nearest, pairing(other, other));
  // |a| = 2 tan(d/2).
  if (!others.empty()) result.nearest = 2 * length_of_tangent(std::sqrt(nearest) / 2);

  double farthest = 0;
  for (const auto& simplex : approximate_star<m>(points, 0)) {
    std::array<Vector<double, m>, static_cast<std::size_t>(m) + 1> vertices;
    for (std::size_t corner = 0; corner <= m; ++corner) vertices[corner] = points[simplex[corner]];
    const auto sphere = approximate_sphere<m>(cartesian<m>(), vertices);
    if (!std::isfinite(sphere.squared_radius)) continue;
    result.is_cut_off = result.is_cut_off || simplex.back() >= first_post;
    farthest = std::max(farthest, sphere.squared_radius);
    result.sphere_centres.push_back(sphere.centre);
    std::array<Vector<double, m>, static_cast<std::size_t>(m)> corners;
    std::copy(vertices.begin() + 1, vertices.end(), corners.begin());
    result.simplices.push_back(corners);
  }
  result.farthest_vertex = length_of_tangent(std::min(std::sqrt(farthest), most_tangent_));
  return result;
}

template <int m>
Vector<double, m> VoronoiCells<m>::mass_centre(const Cell& cell) {
  if (cell.is_cut_off) return {};
  double volume = 0;
  Vector<double, m> moment{};
  for (const auto& simplex : cell.simplices) add_flags<m>(simplex, volume, moment);
  return volume > 0 ? scaled(1 / volume, moment) : Vector<double, m>{};
}

template class VoronoiCells<1>;
template class VoronoiCells<2>;
template class VoronoiCells<3>;

}  // namespace delcert
