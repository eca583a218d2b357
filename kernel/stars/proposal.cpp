#include "kernel/stars/proposal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/manifold/lattice.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "kernel/stars/approximate_sphere.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// How many whole cells of copies on each side are tried before the points are declared too few.
constexpr int most_copies = 3;

template <int m>
struct Copies {
  std::vector<Lift<m>> lifts;
  std::vector<Vector<double, m>> frame;
  std::vector<Vector<double, m>> cartesian;

  void add(const FrameMetric<m>& metric, std::uint32_t index, const Vector<double, m>& point, const Shift<m>& shift) {
    Vector<double, m> moved = point;
    for (std::size_t axis = 0; axis < m; ++axis) moved[axis] += static_cast<double>(shift[axis]);
    lifts.push_back({index, shift});
    frame.push_back(moved);
    cartesian.push_back(metric.approximate_cartesian(moved));
  }
};

/// The lifts in the unit cell widened by `margin` (a length).
template <int m>
Copies<m> copies_around_unit_cell(const FrameMetric<m>& metric, const std::vector<Vector<double, m>>& points,
                                  double margin) {
  Vector<double, m> half;
  for (std::size_t axis = 0; axis < m; ++axis) {
    half[axis] = margin * std::sqrt(approximate_double(metric.inverse_diagonal(axis)));
  }
  Copies<m> result;
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    require_moderate_coordinates<m>(index, points[index]);
    Shift<m> first;
    Shift<m> last;
    for (std::size_t axis = 0; axis < m; ++axis) {
      first[axis] = static_cast<std::int32_t>(std::ceil(-half[axis] - points[index][axis]));
      last[axis] = static_cast<std::int32_t>(std::floor(1 + half[axis] - points[index][axis]));
    }
    Shift<m> shift = first;
    while (true) {
      result.add(metric, index, points[index], shift);
      std::size_t axis = m;
      while (axis > 0 && ++shift[axis - 1] > last[axis - 1]) {
        shift[axis - 1] = first[axis - 1];
        --axis;
      }
      if (axis == 0) break;
    }
  }
  return result;
}

template <int m>
bool is_in_unit_cell(const Vector<double, m>& x) {
  return std::all_of(x.begin(), x.end(), [](double coordinate) { return coordinate >= 0 && coordinate < 1; });
}

template <int m>
LiftedSimplex<m> lifted(const Copies<m>& copies, const IndexSimplex<m>& simplex) {
  LiftedSimplex<m> result;
  for (std::size_t corner = 0; corner <= m; ++corner) result[corner] = copies.lifts[simplex[corner]];
  return canonical<m>(result);
}

/// The simplices with a vertex in the unit cell, and the largest of their circumradii.
template <int m>
std::pair<std::vector<LiftedSimplex<m>>, double> simplices_at_unit_cell(const FrameMetric<m>& metric,
                                                                        const Copies<m>& copies) {
  const auto plain = metric.template on<PlainDouble>();
  std::pair<std::vector<LiftedSimplex<m>>, double> result{{}, 0};
  for (const IndexSimplex<m>& simplex : approximate_delaunay<m>(copies.cartesian)) {
    const auto touches = [&copies](std::uint32_t vertex) { return is_in_unit_cell<m>(copies.frame[vertex]); };
    if (std::none_of(simplex.begin(), simplex.end(), touches)) continue;
    std::array<Vector<double, m>, static_cast<std::size_t>(m) + 1> vertices;
    for (std::size_t corner = 0; corner <= m; ++corner) vertices[corner] = copies.frame[simplex[corner]];
    const auto sphere = approximate_sphere<m>(plain, vertices);
    if (std::isfinite(sphere.squared_radius)) result.second = std::max(result.second, std::sqrt(sphere.squared_radius));
    result.first.push_back(lifted<m>(copies, simplex));
  }
  std::sort(result.first.begin(), result.first.end());
  result.first.erase(std::unique(result.first.begin(), result.first.end()), result.first.end());
  return result;
}

/// How large a coordinate of a vector of length 1 can be: large in a skewed basis.
template <int m>
double coordinate_of_a_unit(const FrameMetric<m>& metric) {
  double result = 0;
  for (std::size_t axis = 0; axis < m; ++axis)
    result = std::max(result, std::sqrt(approximate_double(metric.inverse_diagonal(axis))));
  return result;
}

}  // namespace

template <int m>
LiftedSimplex<m> canonical(LiftedSimplex<m> simplex) {
  std::sort(simplex.begin(), simplex.end());
  const Shift<m> base = simplex[0].shift;
  for (Lift<m>& vertex : simplex) vertex.shift = difference_of<m>(vertex.shift, base);
  return simplex;
}

template <int m>
std::vector<LiftedSimplex<m>> propose_delaunay(const FlatSpace<m>& space, const std::vector<Vector<double, m>>& points,
                                               double usual_circumradius) {
  if (!space.is_torus()) {
    Copies<m> all;
    for (std::uint32_t index = 0; index < points.size(); ++index) all.add(space.metric, index, points[index], {});
    std::vector<LiftedSimplex<m>> result;
    for (const auto& simplex : approximate_delaunay<m>(all.cartesian)) result.push_back(lifted<m>(all, simplex));
    if (result.empty()) throw Rejection("the points span no simplex of dimension " + std::to_string(m));
    std::sort(result.begin(), result.end());
    return result;
  }
  const double widest = coordinate_of_a_unit<m>(space.metric);
  double enough = std::numeric_limits<double>::infinity();
  for (double most = 2.5 * usual_circumradius; most * widest <= most_copies; most *= 2) {
    const double margin = std::min(most, enough);
    auto [simplices, largest] =
        simplices_at_unit_cell<m>(space.metric, copies_around_unit_cell<m>(space.metric, points, margin));
    // A ball of radius R through a point of the cell lies within 2R of the cell: it has seen all the points it could.
    if (!simplices.empty() && 2 * largest <= margin) return simplices;
    // More points make no Voronoi cell larger.
    if (!simplices.empty()) enough = 2 * largest * (1 + 0x1p-20);
  }
  const Matrix<Rational, m> reduced = reduced_gram<m>(space.metric);
  if (2 * coordinate_of_a_unit<m>(FrameMetric<m>(reduced)) < widest) {
    throw InputError(
        "the lattice basis is too skewed for a Delaunay triangulation of the torus: describe the same torus by a "
        "reduced basis, " +
        gram_text<m>(reduced));
  }
  throw Rejection("the points are too few, or too unevenly spread, for a Delaunay triangulation of the torus");
}

#define DELCERT_INSTANTIATE(m)                                                    \
  template LiftedSimplex<m> canonical<m>(LiftedSimplex<m>);                       \
  template std::vector<LiftedSimplex<m>> propose_delaunay<m>(const FlatSpace<m>&, \
                                                             const std::vector<Vector<double, m>>&, double);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
