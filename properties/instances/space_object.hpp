#pragma once

#include <optional>
#include <vector>

#include "kernel/chart/curved_functions.hpp"
#include "proofs/formula/vocabulary.hpp"
#include "properties/instances/exact_point.hpp"

namespace delcert {

namespace types {
inline const Type space_points{"space-points", false};
}  // namespace types

/// The conformal coordinates of a point about another one, in the frame that is that of the origin, moved along the
/// geodesic between them. Exact. Nothing for the antipode. Preconditions: both are points of the space of curvature
/// K = ±1 by such coordinates about the origin, two or all three.
[[nodiscard]] std::optional<ExactPoint> seen_by(Curvature curvature, const ExactPoint& centre, const ExactPoint& point);

/// Points of a sphere or of a hyperbolic space of dimension 2 or 3 and sectional curvature K/R², K = ±1, R a length.
///
/// Each point by its conformal coordinates a about an origin o, rational and in units of R: a has the direction of the
/// geodesic from o, and |a| = 2 tan(d/2) for K = 1, 2 tanh(d/2) for K = −1, where dR is the distance from o. So what
/// one point sees of another is rational again, and only lengths are not.
class SpaceObject : public Object {
 public:
  /// Throws InputError unless K = ±1, R > 0, there is a point, all have two or all three coordinates, and |a| < 2 in
  /// hyperbolic space.
  SpaceObject(Curvature curvature, Rational unit, std::vector<ExactPoint> points);

  [[nodiscard]] Curvature curvature() const { return curvature_; }
  /// R.
  [[nodiscard]] const Rational& unit() const { return unit_; }
  [[nodiscard]] const std::vector<ExactPoint>& points() const { return points_; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] int dimension() const { return static_cast<int>(points_.front().size()); }

  /// `seen_by` of two of the points. Throws InputError for a number without a point.
  [[nodiscard]] std::optional<ExactPoint> seen_from(std::size_t centre, std::size_t point) const;

  [[nodiscard]] nlohmann::ordered_json json() const override;
  [[nodiscard]] static ObjectPointer read(const nlohmann::ordered_json& json);

 private:
  Curvature curvature_;
  Rational unit_;
  std::vector<ExactPoint> points_;
};

/// The length of the conformal coordinates at a distance of d units: 2 tan(d/2) or 2 tanh(d/2), rounded down by at most
/// 2⁻⁵⁰ of it. Precondition: K = ±1, d ≥ 0, and d ≤ 3 on the sphere.
[[nodiscard]] Rational conformal_length(Curvature curvature, const Rational& distance);

}  // namespace delcert
