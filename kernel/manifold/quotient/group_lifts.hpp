#pragma once

#include <optional>
#include <vector>

#include "kernel/manifold/quotient/element_table.hpp"
#include "kernel/manifold/quotient/enclosed_polyhedron.hpp"
#include "kernel/manifold/quotient/space_form.hpp"

namespace delcert {

/// Where the chosen lifts of some points of a space form are.
struct LiftBounds {
  /// Not below any distance from o.
  double radius = 0;
  /// Of a hyperbolic manifold: whether all are certainly in its polyhedron P.
  bool in_polyhedron = false;
};

/// The elements of a group that are needed to see all lifts of such points within `reach` of each other, and the lifts.
///
/// With D the radius, d(x, γy) ≤ reach implies d(o, γo) ≤ reach + 2D: the elements are all with that (a finite group:
/// all). For x and y in P those of the tiles near P do, which are fewer to walk. (docs/space-forms.md, Elements within
/// a radius)
template <int m>
class GroupLifts {
 public:
  GroupLifts(const SpaceForm& form, const LiftBounds& bounds, double reach);

  [[nodiscard]] const ElementTable<m>& table() const { return table_; }

  /// Calls visit(number, γx) for all γ ≠ 1 with γx within the reach of a point of those bounds, and for some more.
  /// Precondition: x is one of these points; a `RoundingGuard` is alive.
  template <class Visit>
  void for_each_lift(const ModelPoint<Interval, m>& x, const Visit& visit) const {
    for (std::uint32_t number = 1; number < table_.size(); ++number) {
      const auto& matrix = table_.matrix(number);
      if (curvature_ != Curvature::zero && is_far_from_origin(pairing(matrix[0], x))) continue;
      const auto lift = applied(matrix, x);
      if (!is_far(lift)) visit(number, lift);
    }
  }

 private:
  /// From the first coordinate, for curvature ±1.
  [[nodiscard]] bool is_far_from_origin(const Interval& first) const {
    return is_proved(curvature_ == Curvature::positive ? less(first, farthest_) : less(farthest_, first));
  }
  [[nodiscard]] bool is_far(const ModelPoint<Interval, m>& lift) const;

  Curvature curvature_;
  ElementTable<m> table_;
  std::optional<MetricOn<Interval, m>> metric_;
  std::optional<EnclosedPolyhedron<m>> polyhedron_;
  Interval farthest_;    // cosine of reach + radius, its square, hyperbolic cosine
  Interval sine_reach_;  // hyperbolic sine of the reach
};

/// The bounds of points that are given by enclosures. Precondition: a `RoundingGuard` is alive.
template <int m>
[[nodiscard]] LiftBounds lift_bounds(const SpaceForm& form, const std::vector<ModelPoint<Interval, m>>& points);

}  // namespace delcert
