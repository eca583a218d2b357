#include "kernel/stars/proposal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/manifold/lattice.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "kernel/stars/approximate_sphere.hpp"
#include "support/error.hpp"
#include "support/sort_by_number.hpp"

namespace delcert {

namespace {

/// How many whole cells of copies on each side are tried before the points are declared too few.
constexpr int most_copies = 3;

/// By which lattice vectors a point is moved into the unit cell widened by so much along each axis.
template <int m>
struct CopyRange {
  Shift<m> first;
  Shift<m> last;

  CopyRange(const Vector<double, m>& point, const Vector<double, m>& half) {
    for (std::size_t axis = 0; axis < m; ++axis) {
      first[axis] = static_cast<std::int32_t>(std::ceil(-half[axis] - point[axis]));
      last[axis] = static_cast<std::int32_t>(std::floor(1 + half[axis] - point[axis]));
    }
  }
  [[nodiscard]] bool contains(const Shift<m>& shift) const {
    for (std::size_t axis = 0; axis < m; ++axis) {
      if (shift[axis] < first[axis] || shift[axis] > last[axis]) return false;
    }
    return true;
  }
  template <class Visit>
  void visit(const Visit& visit) const {
    Shift<m> shift = first;
    while (true) {
      visit(shift);
      std::size_t axis = m;
      while (axis > 0 && ++shift[axis - 1] > last[axis - 1]) {
        shift[axis - 1] = first[axis - 1];
        --axis;
      }
      if (axis == 0) return;
    }
  }
};

template <int m>
Vector<double, m> half_widths(const FrameMetric<m>& metric, double margin) {
  Vector<double, m> result;
  for (std::size_t axis = 0; axis < m; ++axis)
    result[axis] = margin * std::sqrt(approximate_double(metric.inverse_diagonal(axis)));
  return result;
}

template <int m>
bool is_in_unit_cell(const Vector<double, m>& x) {
  return std::all_of(x.begin(), x.end(), [](double coordinate) { return coordinate >= 0 && coordinate < 1; });
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
void sort_canonical(std::vector<LiftedSimplex<m>>& simplices) {
  sort_by_number(simplices, [](const LiftedSimplex<m>& simplex) { return simplex[0].index; });
}

template <int m>
void GrowingProposal<m>::add_copies(const std::vector<Vector<double, m>>& points, double margin) {
  const auto half = half_widths<m>(space_.metric, margin);
  const auto known_half = half_widths<m>(space_.metric, margin_);
  std::vector<Vector<double, m>> cartesian;
  const auto add = [&](std::uint32_t index, const Shift<m>& shift) {
    Vector<double, m> moved = points[index];
    for (std::size_t axis = 0; axis < m; ++axis) moved[axis] += static_cast<double>(shift[axis]);
    lifts_.push_back({index, shift});
    frame_.push_back(moved);
    is_in_unit_cell_.push_back(!space_.is_torus() || is_in_unit_cell<m>(moved) ? 1 : 0);
    cartesian.push_back(space_.metric.approximate_cartesian(moved));
  };
  const auto first = static_cast<std::uint32_t>(space_.is_torus() && margin > margin_ ? 0 : known_);
  for (std::uint32_t index = first; index < points.size(); ++index) {
    if (!space_.is_torus()) {
      add(index, {});
      continue;
    }
    require_moderate_coordinates<m>(index, points[index]);
    const CopyRange<m> known(points[index], known_half);
    CopyRange<m>(points[index], half).visit([&](const Shift<m>& shift) {
      if (index >= known_ || !known.contains(shift)) add(index, shift);
    });
  }
  triangulation_.add(cartesian);
  known_ = points.size();
  margin_ = margin;
}

template <int m>
std::pair<std::vector<LiftedSimplex<m>>, double> GrowingProposal<m>::simplices_at_unit_cell() const {
  const auto plain = space_.metric.template on<PlainDouble>();
  const auto found = triangulation_.simplices_at(is_in_unit_cell_);
  std::pair<std::vector<LiftedSimplex<m>>, double> result{{}, 0};
  result.first.reserve(found.size());
  for (const IndexSimplex<m>& simplex : found) {
    std::array<Vector<double, m>, static_cast<std::size_t>(m) + 1> vertices;
    LiftedSimplex<m> lifted;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      vertices[corner] = frame_[simplex[corner]];
      lifted[corner] = lifts_[simplex[corner]];
    }
    const auto sphere = approximate_sphere<m>(plain, vertices);
    if (std::isfinite(sphere.squared_radius)) result.second = std::max(result.second, std::sqrt(sphere.squared_radius));
    result.first.push_back(canonical<m>(lifted));
  }
  sort_canonical<m>(result.first);
  result.first.erase(std::unique(result.first.begin(), result.first.end()), result.first.end());
  return result;
}

template <int m>
std::vector<LiftedSimplex<m>> GrowingProposal<m>::simplices(const std::vector<Vector<double, m>>& points) {
  if (!space_.is_torus()) {
    add_copies(points, 0);
    auto result = simplices_at_unit_cell().first;
    if (result.empty()) throw Rejection("the points span no simplex of dimension " + std::to_string(m));
    return result;
  }
  const double widest = coordinate_of_a_unit<m>(space_.metric);
  double enough = std::numeric_limits<double>::infinity();
  for (double most = 2.5 * usual_circumradius_; most * widest <= most_copies; most *= 2) {
    add_copies(points, std::max(margin_, std::min(most, enough)));
    auto [simplices, largest] = simplices_at_unit_cell();
    // A ball of radius R through a point of the cell lies within 2R of the cell: it has seen all the points it could.
    if (!simplices.empty() && 2 * largest <= margin_) return simplices;
    // More points make no Voronoi cell larger.
    if (!simplices.empty()) enough = 2 * largest * (1 + 0x1p-20);
  }
  const Matrix<Rational, m> reduced = reduced_gram<m>(space_.metric);
  if (2 * coordinate_of_a_unit<m>(FrameMetric<m>(reduced)) < widest) {
    throw InputError(
        "the lattice basis is too skewed for a Delaunay triangulation of the torus: describe the same torus by a "
        "reduced basis, " +
        gram_text<m>(reduced));
  }
  throw Rejection("the points are too few, or too unevenly spread, for a Delaunay triangulation of the torus");
}

template <int m>
std::vector<LiftedSimplex<m>> propose_delaunay(const FlatSpace<m>& space, const std::vector<Vector<double, m>>& points,
                                               double usual_circumradius) {
  return GrowingProposal<m>(space, usual_circumradius).simplices(points);
}

#define DELCERT_INSTANTIATE(m)                                                    \
  template LiftedSimplex<m> canonical<m>(LiftedSimplex<m>);                       \
  template void sort_canonical<m>(std::vector<LiftedSimplex<m>>&);                \
  template class GrowingProposal<m>;                                              \
  template std::vector<LiftedSimplex<m>> propose_delaunay<m>(const FlatSpace<m>&, \
                                                             const std::vector<Vector<double, m>>&, double);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
