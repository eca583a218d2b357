#pragma once

#include <vector>

#include "kernel/chart/lift_grid.hpp"
#include "kernel/sample/space_form_domain.hpp"

namespace delcert {

template <int m>
struct SpaceFormNet {
  /// Conformal coordinates of one lift of each point, the one nearest to o (for curvature 0: coordinates of the frame).
  /// Multiples of 2⁻⁴⁸, and doubles. In the order of a space-filling curve.
  std::vector<Vector<Rational, m>> centres;
  /// In doubles, without error bounds: the greatest distance of a point of M from the net, the least in it.
  double covering_radius = 0;
  double separation = 0;
};

/// Points of a space form that is being sampled, with the lifts within a reach of each; in doubles, without error
/// bounds. Everything needs rounding to nearest.
template <int m>
class SpaceFormPoints {
 public:
  SpaceFormPoints(const SpaceForm& form, double reach);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] Curvature curvature() const { return domain_.curvature(); }
  [[nodiscard]] const SpaceFormDomain<m>& domain() const { return domain_; }

  /// Adds a point by its coordinates, unless some lift of another is within the distance, or the coordinates are 2³⁰ or
  /// more (−o has none); says whether it did. Throws Rejection for more than 4 000 000 points.
  bool insert(const Vector<double, m>& coordinates, double least_distance);

  /// The lifts within the reach of a point but itself, seen from it: Cartesian conformal coordinates.
  void look_about(std::uint32_t label, std::vector<Vector<double, m>>& around) const;
  /// The coordinates of the point that is seen there from a label.
  [[nodiscard]] Vector<double, m> at(std::uint32_t label, const Vector<double, m>& cartesian) const;

  /// The points, exactly, in the order of a space-filling curve.
  [[nodiscard]] std::vector<Vector<Rational, m>> ordered() const;

 private:
  [[nodiscard]] LiftGrid<m> empty_grid() const;
  [[nodiscard]] ModelPoint<Interval, m> enclosed(const Vector<double, m>& coordinates) const;
  [[nodiscard]] Frame<PlainDouble, m> frame(std::uint32_t label) const;

  double reach_;
  FrameMetric<m> metric_;
  SpaceFormDomain<m> domain_;
  LiftGrid<m> grid_;
  std::vector<Vector<double, m>> points_;
};

}  // namespace delcert
