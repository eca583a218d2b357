#pragma once

#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"

namespace delcert {

/// Of a triangle with these corners: the minors of two edges.
template <class S>
[[nodiscard]] std::array<S, 3> normal_of(const std::array<std::array<S, 3>, 3>& corners) {
  std::array<S, 3> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t one = (axis + 1) % 3;
    const std::size_t other = (axis + 2) % 3;
    result[axis] = (corners[1][one] - corners[0][one]) * (corners[2][other] - corners[0][other]) -
                   (corners[1][other] - corners[0][other]) * (corners[2][one] - corners[0][one]);
  }
  return result;
}

/// Twice the area, in the plane of the first two coordinates, of the triangle of (x, y) and an edge.
template <class S>
[[nodiscard]] S side_of(const std::array<std::array<S, 3>, 3>& corners, std::size_t edge, const S& x, const S& y) {
  const auto& from = corners[edge];
  const auto& to = corners[(edge + 1) % 3];
  return (to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0]);
}

/// A facet as a chart shows it: its vertices in coordinates of the chart, and its normal there.
struct ShownFacet {
  std::array<std::array<Interval, 3>, 3> corners;
  std::array<Interval, 3> normal;

  /// Needs a `RoundingGuard`.
  ShownFacet(const PolyhedralMesh& mesh, const EnclosedChart<Interval>& chart, std::uint32_t facet);
  /// Twice the area of the triangle of (x, y) and an edge, in the chart's plane.
  [[nodiscard]] Interval side(std::size_t edge, const Interval& x, const Interval& y) const;
  /// Whether no point over (x, y) is in it, certainly. Precondition: the sign of its normal's last entry is known.
  [[nodiscard]] bool is_certainly_not_over(const Interval& x, const Interval& y) const;
};

/// Calls visit(facet) for all facets that may meet a box in coordinates of a chart, and some others. Needs a
/// `RoundingGuard`.
template <class Visit>
void visit_facets(const PolyhedralMesh& mesh, const EnclosedChart<Interval>& chart, const Interval* place,
                  const Visit& visit) {
  const auto may_meet = [&](const SpaceBox& box) {
    std::array<Interval, 3> x;
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = Interval::between(box.lower[axis], box.upper[axis]);
    for (std::size_t column = 0; column < 3; ++column) {
      const Interval along = chart.coordinate(x.data(), column);
      if (along.upper() < place[column].lower() || place[column].upper() < along.lower()) return false;
    }
    return true;
  };
  mesh.tree().visit(may_meet, visit);
}

}  // namespace delcert
