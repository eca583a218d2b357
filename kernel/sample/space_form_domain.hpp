#pragma once

#include <vector>

#include "kernel/manifold/quotient/frame.hpp"
#include "kernel/manifold/quotient/group_lifts.hpp"
#include "kernel/number/plain_double.hpp"
#include "kernel/random/counter_random.hpp"

namespace delcert {

/// Points of a space form X/Γ in doubles, without error bounds: each by the lift that is nearest to o, so that few
/// group elements are needed to see the lifts within a distance. Conformal coordinates, for curvature 0 those of the
/// frame; multiples of 2⁻⁴⁸. Needs rounding to nearest.
template <int m>
class SpaceFormDomain {
 public:
  using Point = ModelPoint<PlainDouble, m>;

  /// `reach`: how far lifts are wanted (see `lifts`).
  SpaceFormDomain(const SpaceForm& form, double reach);

  [[nodiscard]] Curvature curvature() const { return curvature_; }
  /// All lifts within the reach of points of the domain.
  [[nodiscard]] const GroupLifts<m>& lifts() const { return lifts_; }
  [[nodiscard]] const ModelMatrix<PlainDouble, m>& matrix(std::uint32_t number) const { return matrices_[number]; }

  /// A random point of the quotient, about uniform.
  [[nodiscard]] Vector<double, m> random_point(CounterRandom& random) const;
  /// The coordinates of a lift of x that is nearest to o, if it has coordinates: not −o.
  [[nodiscard]] Vector<double, m> reduced(Point x) const;
  /// The model point that has them.
  [[nodiscard]] Point point(const Vector<double, m>& coordinates) const;

 private:
  [[nodiscard]] Point random_in_cover(CounterRandom& random) const;
  /// Grows with the distance from o.
  [[nodiscard]] double remoteness(const Point& x) const;

  Curvature curvature_;
  MetricOn<PlainDouble, m> metric_;
  LiftBounds bounds_;
  GroupLifts<m> lifts_;
  std::vector<ModelMatrix<PlainDouble, m>> matrices_;
  double greatest_coordinate_ = 2;  // |a| of a hyperbolic polyhedron's farthest vertex
};

}  // namespace delcert
