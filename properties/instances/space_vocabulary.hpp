#pragma once

#include "properties/instances/space_object.hpp"

namespace delcert {

/// The distance of two points in the space, a length. Undecided on the rungs of surds and algebraic numbers: it is
/// transcendental. Precondition for S = Interval: a `RoundingGuard` is alive.
template <class S>
[[nodiscard]] Partial<S> distance_in_space(const SpaceObject& space, std::size_t a, std::size_t b);

/// The distance of two points in the exponential chart at a third one, a length: that of their images under exp⁻¹ in
/// the tangent space. On the sphere the chart is the one of the open ball of radius π; no value for the antipode.
/// Undecided and precondition as above.
template <class S>
[[nodiscard]] Partial<S> distance_in_chart(const SpaceObject& space, std::size_t centre, std::size_t a, std::size_t b);

/// Adds the kind of points of a space, and their distances.
void add_space_quantities(Vocabulary& vocabulary);

}  // namespace delcert
