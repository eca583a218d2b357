#pragma once

#include <memory>
#include <optional>

#include "properties/instances/choices.hpp"
#include "properties/instances/configuration_map.hpp"
#include "properties/instances/space_object.hpp"

namespace delcert {

/// The transition exp_i⁻¹ ∘ exp_j between the exponential charts at two points of a sphere or a hyperbolic space, on
/// finitely many points. The space has two points: j, the origin, and i. Its values are transcendental; the map has
/// them rounded, by less than 2⁻⁴⁰ξ times the least distance of two of its points, so that of its distortion, which is
/// that of the rounded values and decided exactly, no more than that part is rounding.
struct ExponentialTransition {
  std::shared_ptr<const SpaceObject> space;
  ConfigurationMap::Finite map;
};

/// One that is defined on the vertices and on the circumcentres of the facets, in the chart at j, of a distortion near
/// ξ, now and then far below, and at most ξ; i is at most `farthest` from j. Nothing if the choices lead to none, or to
/// one that would need thousands of digits. Preconditions: in two or three dimensions, no facet is degenerate, ξ > 0,
/// farthest > 0.
[[nodiscard]] std::optional<ExponentialTransition> exponential_transition(const SimplexObject::Points& vertices,
                                                                          const Rational& distortion,
                                                                          const Rational& farthest, Choices& choices);

/// The transition of this space on these points, with ξ for its distortion, whether or not it keeps to it. Nothing
/// where a point is seen as the antipode of i, or thousands of digits would be needed. Preconditions: the space has two
/// points, the first the origin; the points have its dimension, and two of them are different; ξ > 0.
[[nodiscard]] std::optional<ConfigurationMap::Finite> rounded_transition(const SpaceObject& space,
                                                                         SimplexObject::Points points,
                                                                         const Rational& distortion);

/// Whether the images of the map are those of `rounded_transition` for its points and distortion, but for another
/// rounding of the last digit. Preconditions: as there.
[[nodiscard]] bool is_transition_of(const SpaceObject& space, const ConfigurationMap::Finite& map);

}  // namespace delcert
