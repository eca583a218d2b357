#include "kernel/stars/proposal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/manifold/lattice.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "kernel/stars/approximate_sphere.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// How many whole cells of copies on each side are tried before the points are declared too few.
constexpr int most_copies = 3;

/// Around how many usual circumradii copies are made at first.
constexpr double usual_margin = 1.25;

/// Boxes have so many points at least, are no more than these, and have no more than this times the points of the unit
/// cell together: a thread does more work then, but two of them do it at once.
constexpr std::size_t points_of_a_box = 1000;
constexpr std::int32_t most_boxes = 16;
constexpr double most_copied = 1.5;

/// By which lattice vectors a point is moved into a box, its corners widened by so much along each axis.
template <int m>
struct CopyRange {
  Shift<m> first;
  Shift<m> last;

  CopyRange(const Vector<double, m>& point, const Vector<double, m>& low, const Vector<double, m>& high,
            const Vector<double, m>& half) {
    for (std::size_t axis = 0; axis < m; ++axis) {
      first[axis] = static_cast<std::int32_t>(std::ceil(low[axis] - half[axis] - point[axis]));
      last[axis] = static_cast<std::int32_t>(std::floor(high[axis] + half[axis] - point[axis]));
    }
  }
  [[nodiscard]] bool is_empty() const {
    for (std::size_t axis = 0; axis < m; ++axis) {
      if (first[axis] > last[axis]) return true;
    }
    return false;
  }
  [[nodiscard]] bool contains(const Shift<m>& shift) const {
    for (std::size_t axis = 0; axis < m; ++axis) {
      if (shift[axis] < first[axis] || shift[axis] > last[axis]) return false;
    }
    return true;
  }
  template <class Visit>
  void visit(const Visit& visit) const {
    if (is_empty()) return;
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

/// How large a coordinate of a vector of length 1 can be: large in a skewed basis.
template <int m>
double coordinate_of_a_unit(const FrameMetric<m>& metric) {
  double result = 0;
  for (std::size_t axis = 0; axis < m; ++axis)
    result = std::max(result, std::sqrt(approximate_double(metric.inverse_diagonal(axis))));
  return result;
}

/// The volume of a simplex, times m!, in frame coordinates.
template <int m>
double approximate_volume(const std::array<Vector<double, m>, static_cast<std::size_t>(m) + 1>& vertices) {
  std::array<Vector<double, m>, static_cast<std::size_t>(m)> edges;
  for (std::size_t at = 0; at < m; ++at) edges[at] = difference(vertices[at + 1], vertices[0]);
  return std::abs(pairing(wedge(edges), edges[m - 1]));
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
std::vector<LiftedSimplex<m>> in_order(const std::vector<std::vector<LiftedSimplex<m>>>& lists, std::size_t points) {
  // Those of each first vertex together.
  std::vector<std::size_t> begin(points + 1, 0);
  for (const auto& list : lists) {
    for (const LiftedSimplex<m>& simplex : list) ++begin[simplex[0].index + std::size_t{1}];
  }
  for (std::size_t index = 0; index < points; ++index) begin[index + 1] += begin[index];
  std::vector<LiftedSimplex<m>> result(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const auto& list : lists) {
    for (const LiftedSimplex<m>& simplex : list) result[next[simplex[0].index]++] = simplex;
  }
  const auto sort_some = [&](std::size_t first, std::size_t last) {
    const auto at = [&](std::size_t index) { return result.begin() + static_cast<std::ptrdiff_t>(begin[index]); };
    for (std::size_t index = first; index < last; ++index) std::sort(at(index), at(index + 1));
    return true;
  };
  in_parts<1024>("triangulate", points, no_progress(), sort_some, [](bool) {});
  return result;
}

template <int m>
struct GrowingProposal<m>::Box {
  Shift<m> place{};  // its number along each axis
  std::vector<Lift<m>> lifts;
  GrowingDelaunay<m> triangulation;
};

template <int m>
GrowingProposal<m>::GrowingProposal(const FlatSpace<m>& space, double usual_circumradius)
    : space_(space), usual_circumradius_(usual_circumradius) {
  division_.fill(1);
}
template <int m>
GrowingProposal<m>::~GrowingProposal() = default;

template <int m>
void GrowingProposal<m>::divide(std::size_t points) {
  const auto half = half_widths<m>(space_.metric, usual_margin * usual_circumradius_);
  std::int32_t count = 1;
  while (space_.is_torus() && 2 * count <= most_boxes && points / points_of_a_box >= 2 * std::size_t(count)) {
    // The longest sides are halved.
    Shift<m> finer = division_;
    const auto divided = [&](std::size_t axis) { return half[axis] * finer[axis]; };
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < m; ++axis) {
      if (divided(axis) < divided(longest)) longest = axis;
    }
    finer[longest] *= 2;
    double copied = 1;
    for (std::size_t axis = 0; axis < m; ++axis) copied *= 1 + 2 * divided(axis);
    if (!(copied <= most_copied)) break;
    division_ = finer;
    count *= 2;
  }
  for (std::int32_t number = 0; number < count; ++number) {
    auto& box = boxes_.emplace_back(std::make_unique<Box>());
    std::int32_t rest = number;
    for (std::size_t axis = 0; axis < m; ++axis) {
      box->place[axis] = rest % division_[axis];
      rest /= division_[axis];
    }
  }
}

template <int m>
void GrowingProposal<m>::add_copies(const std::vector<Vector<double, m>>& points, double margin) {
  for (std::size_t index = known_; space_.is_torus() && index < points.size(); ++index)
    require_moderate_coordinates<m>(static_cast<std::uint32_t>(index), points[index]);
  in_parts<1>(
      "triangulate", boxes_.size(), no_progress(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t at = first; at < last; ++at) add_copies(points, margin, *boxes_[at]);
        return true;
      },
      [](bool) {});
  known_ = points.size();
  margin_ = margin;
}

template <int m>
void GrowingProposal<m>::add_copies(const std::vector<Vector<double, m>>& points, double margin, Box& box) const {
  const auto half = half_widths<m>(space_.metric, margin);
  const auto known_half = half_widths<m>(space_.metric, margin_);
  Vector<double, m> low;
  Vector<double, m> high;
  for (std::size_t axis = 0; axis < m; ++axis) {
    low[axis] = static_cast<double>(box.place[axis]) / division_[axis];
    high[axis] = static_cast<double>(box.place[axis] + 1) / division_[axis];
  }
  std::vector<Vector<double, m>> cartesian;
  const auto add = [&](std::uint32_t index, const Shift<m>& shift) {
    Vector<double, m> moved = points[index];
    for (std::size_t axis = 0; axis < m; ++axis) moved[axis] += static_cast<double>(shift[axis]);
    box.lifts.push_back({index, shift});
    cartesian.push_back(space_.metric.approximate_cartesian(moved));
  };
  const auto first = static_cast<std::uint32_t>(space_.is_torus() && margin > margin_ ? 0 : known_);
  for (std::uint32_t index = first; index < points.size(); ++index) {
    if (!space_.is_torus()) {
      add(index, {});
      continue;
    }
    const CopyRange<m> known(points[index], low, high, known_half);
    CopyRange<m>(points[index], low, high, half).visit([&](const Shift<m>& shift) {
      if (index >= known_ || !known.contains(shift)) add(index, shift);
    });
  }
  box.triangulation.add(cartesian);
}

template <int m>
typename GrowingProposal<m>::Found GrowingProposal<m>::found(const std::vector<Vector<double, m>>& points) const {
  std::vector<Found> parts;
  in_parts<1>(
      "triangulate", boxes_.size(), no_progress(),
      [&](std::size_t first, std::size_t) { return found_in(points, *boxes_[first]); },
      [&](Found part) { parts.push_back(std::move(part)); });
  Found result;
  std::vector<std::vector<LiftedSimplex<m>>> lists;
  for (Found& part : parts) {
    result.largest = std::max(result.largest, part.largest);
    result.volume += part.volume;
    lists.push_back(std::move(part.simplices));
  }
  result.simplices = in_order<m>(lists, points.size());
  return result;
}

template <int m>
typename GrowingProposal<m>::Found GrowingProposal<m>::found_in(const std::vector<Vector<double, m>>& points,
                                                                const Box& box) const {
  // A place is in one box, and at one of the lifts of a simplex: so each simplex is found once.
  const auto is_here = [&](const Vector<double, m>& place, const Shift<m>& shift) {
    for (std::size_t axis = 0; axis < m; ++axis) {
      const double whole = std::floor(place[axis]);
      if (whole != -static_cast<double>(shift[axis])) return false;
      const auto number = static_cast<std::int32_t>((place[axis] - whole) * division_[axis]);
      if (std::min(number, division_[axis] - 1) != box.place[axis]) return false;
    }
    return true;
  };
  const auto plain = space_.metric.template on<PlainDouble>();
  Found result;
  for (const IndexSimplex<m>& indices : box.triangulation.simplices()) {
    LiftedSimplex<m> simplex;
    for (std::size_t corner = 0; corner <= m; ++corner) simplex[corner] = box.lifts[indices[corner]];
    std::sort(simplex.begin(), simplex.end());
    const Shift<m> shift = simplex[0].shift;
    std::array<Vector<double, m>, static_cast<std::size_t>(m) + 1> vertices;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      simplex[corner].shift = difference_of<m>(simplex[corner].shift, shift);
      vertices[corner] = points[simplex[corner].index];
      for (std::size_t axis = 0; axis < m; ++axis)
        vertices[corner][axis] += static_cast<double>(simplex[corner].shift[axis]);
    }
    if (space_.is_torus()) {
      // What looks degenerate is at the hull of the copies, where several are nearly in a row.
      const auto sphere = approximate_sphere<m>(plain, vertices);
      if (!std::isfinite(sphere.squared_radius) || !is_here(sphere.centre, shift)) continue;
      result.largest = std::max(result.largest, std::sqrt(sphere.squared_radius));
      result.volume += approximate_volume<m>(vertices);
    }
    result.simplices.push_back(simplex);
  }
  return result;
}

template <int m>
std::vector<LiftedSimplex<m>> GrowingProposal<m>::simplices(const std::vector<Vector<double, m>>& points) {
  if (boxes_.empty()) divide(points.size());
  if (!space_.is_torus()) {
    add_copies(points, 0);
    auto result = found(points).simplices;
    if (result.empty()) throw Rejection("the points span no simplex of dimension " + std::to_string(m));
    return result;
  }
  double unit_cell = 1;
  for (int factor = 2; factor <= m; ++factor) unit_cell *= factor;
  const double widest = coordinate_of_a_unit<m>(space_.metric);
  double enough = std::numeric_limits<double>::infinity();
  std::vector<LiftedSimplex<m>> doubtful;
  for (double most = usual_margin * usual_circumradius_; 2 * most * widest <= most_copies; most *= 2) {
    add_copies(points, std::max(margin_, std::min(most, enough)));
    auto [simplices, largest, volume] = found(points);
    if (simplices.empty()) continue;
    // More points make no Voronoi cell larger.
    enough = largest * (1 + 0x1p-20);
    // A ball of radius R about a point of the box lies within R of it: it has seen all the points it could.
    if (!(largest * (1 + 0x1p-30) <= margin_)) continue;
    // If nothing is missing, not even a simplex that would be found at the copy of a point that is not there. Where
    // ties are not broken in the same way everywhere, more copies are no help.
    const double usual = unit_cell / static_cast<double>(simplices.size());
    if (std::abs(volume - unit_cell) < 0x1p-10 * usual || !doubtful.empty()) return simplices;
    doubtful = std::move(simplices);
    enough = std::numeric_limits<double>::infinity();
  }
  if (!doubtful.empty()) return doubtful;
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

#define DELCERT_INSTANTIATE(m)                                                                                        \
  template LiftedSimplex<m> canonical<m>(LiftedSimplex<m>);                                                           \
  template std::vector<LiftedSimplex<m>> in_order<m>(const std::vector<std::vector<LiftedSimplex<m>>>&, std::size_t); \
  template class GrowingProposal<m>;                                                                                  \
  template std::vector<LiftedSimplex<m>> propose_delaunay<m>(const FlatSpace<m>&,                                     \
                                                             const std::vector<Vector<double, m>>&, double);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
