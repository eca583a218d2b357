#pragma once

#include <optional>

#include "properties/instances/space_object.hpp"

namespace delcert {

/// What is certain (docs/distortion.md) about a net p of a space and its perturbation q, and about the exponential
/// charts at the first point of p and at the point j. Lengths.
struct CurvedNetBounds {
  Rational separation;         ///< at most the least distance of two points of p, in both charts
  Rational displacement;       ///< at least the greatest distance of a point from its perturbation, in both charts
  Rational distortion;         ///< at least ξ of the transition from chart i to chart j, on B_i(p_i, 6ε_i)
  Rational metric_distortion;  ///< at least η of chart i on the same ball
  bool has_room = false;       ///< B_i(p_i, 8ε_i) and B_j(p_j, 8ε_j) are certainly parts of B(p_i, 12ε)
};

/// An upper bound of the covering radius in the space, a length, from one in conformal coordinates, in units, that
/// holds for the ball of radius `ball` about the origin in these. Precondition: ball + covering < 2 in hyperbolic
/// space.
[[nodiscard]] Rational covering_in_space(const SpaceObject& net, const Rational& covering, const Rational& ball);

/// The radius in conformal coordinates, rounded up, of the ball about the origin with this radius, a length.
/// Precondition: the radius is at most 3 units.
[[nodiscard]] Rational ball_in_coordinates(const SpaceObject& net, const Rational& radius);

/// Upper bound of the sampling radius in a chart on the ball of 8 of the given radii about its centre, if it is ε in
/// the space. Precondition: rounding to nearest.
[[nodiscard]] Rational radius_in_chart(const SpaceObject& net, const Rational& epsilon, const Rational& radius);

/// The squared least distance of the coordinates of two points. Precondition: there are m + 2, all different.
[[nodiscard]] Rational squared_separation_in_coordinates(const SpaceObject& net);

/// The bounds, if p is ε-dense in the space for the ball of radius 12ε about its first point, which is the origin, and
/// no two of its coordinates are closer than by the squared separation.
/// Preconditions: as many points in q as in p, of the same space, and two at least; j a number among them; all
/// coordinates have a length of at most 1; the radii are at most 1/8 unit, and j is at less than four of them from the
/// first point; rounding to nearest.
[[nodiscard]] CurvedNetBounds curved_net_bounds(const SpaceObject& p, const SpaceObject& q, std::size_t j,
                                                const Rational& epsilon, const Rational& radius_i,
                                                const Rational& radius_j, const Rational& squared_separation);

/// The points of q at less than this distance from the origin, in the space and so in its chart. Nothing where the
/// comparison is not certain, and where there is no point left, or the first one is not among them.
[[nodiscard]] std::optional<SpaceObject> points_within(const SpaceObject& q, const Rational& radius);

}  // namespace delcert
