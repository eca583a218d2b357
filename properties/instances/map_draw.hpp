#pragma once

#include <optional>

#include "properties/instances/choices.hpp"
#include "properties/instances/map_object.hpp"

namespace delcert {

/// A simplex with the centre of one of its circumscribing balls.
struct CentredSimplex {
  SimplexObject::Points points;
  ExactPoint centre;         ///< c
  ExactPoint smallest;       ///< C(σ)
  Rational squared_radius;   ///< of the ball about c
  Rational squared_longest;  ///< Δ(σ)²
};

/// C(σ) plus a normal vector; the vector is 0 where there is none, and if `at_circumcentre`.
/// Nothing for a degenerate simplex.
[[nodiscard]] std::optional<CentredSimplex> with_centre(const SimplexObject& simplex, bool at_circumcentre,
                                                        Choices& choices);

// Maps of distortion at most ξ > 0 whose domain holds the vertices and the centre.

/// Singular values in [1 − ξ, 1 + ξ], many of them at the ends, between two rational reflections.
[[nodiscard]] LinearMap random_linear_map(std::size_t dimension, const Rational& xi, Choices& choices);
/// Bumps of about the width of the simplex.
[[nodiscard]] SmoothMap random_smooth_map(const CentredSimplex& simplex, const Rational& xi, Choices& choices);
/// An inversion whose pole is so far away that on a ball around the simplex it is nearly a reflection; for ξ ≤ ½.
[[nodiscard]] InversionMap random_inversion(const CentredSimplex& simplex, const Rational& xi, Choices& choices);
/// A transition function of a built-in manifold of this dimension; nothing where there is none.
[[nodiscard]] std::optional<TransitionMap> random_transition(std::size_t dimension, Choices& choices);

/// Every point moved along a random vector, as far as ξ allows.
[[nodiscard]] FiniteMap displaced_points(const CentredSimplex& simplex, const Rational& xi, Choices& choices);
/// The simplex shrunk by 1 − ξ, the centre as far from all vertices as ξ allows: over C(σ).
/// Nothing if the simplex fills its space.
[[nodiscard]] std::optional<FiniteMap> lifted_centre(const CentredSimplex& simplex, const Rational& xi,
                                                     Choices& choices);
/// An edge shrunk by 1 − ξ, the centre as far as ξ allows from one end, as near to the other.
/// Nothing unless the simplex is an edge with its centre off its line.
[[nodiscard]] std::optional<FiniteMap> tilted_centre(const CentredSimplex& simplex, const Rational& xi,
                                                     Choices& choices);
/// The vertices mapped to themselves, the centre anywhere and not in U.
[[nodiscard]] FiniteMap with_centre_outside(const CentredSimplex& simplex, Choices& choices);

/// A distortion that the map has on U, rounded up by at most 2⁻⁴⁰; the least one for finite and inverse maps, the bound
/// by the displacement for smooth ones, 0 for transitions. For linear maps the given bound is returned.
[[nodiscard]] Rational certified_distortion(const MapObject& map, const Rational& bound);

/// The manifolds that `random_transition` knows, by name.
[[nodiscard]] const std::vector<std::string>& manifolds_with_rational_lattices();

}  // namespace delcert
