#pragma once

#include <vector>

#include "proofs/formula/simplex_object.hpp"

namespace delcert {

/// A point of the unit sphere with rational coordinates, about 2^−bits from the given direction: the stereographic
/// projection, rounded, and back (Pythagorean parametrisation). The last axis stands for the direction 0.
[[nodiscard]] std::vector<Rational> rational_direction(const std::vector<double>& direction, unsigned bits);

/// The parallel of the unit sphere at the height (1 − q²)/(1 + q²): its point in direction `z`, itself a unit vector of
/// one dimension less. The last axis is that of the height.
[[nodiscard]] std::vector<Rational> point_of_parallel(const Rational& q, const std::vector<Rational>& z);

/// All coordinates multiplied.
[[nodiscard]] SimplexObject::Points scaled_points(SimplexObject::Points points, const Rational& factor);

/// The points mirrored in the hyperplane through the origin that is orthogonal to `normal`; the same points for 0.
[[nodiscard]] SimplexObject::Points mirrored_points(SimplexObject::Points points, const std::vector<Rational>& normal);

/// Coordinates 0 added up to the dimension.
[[nodiscard]] SimplexObject::Points embedded_points(SimplexObject::Points points, std::size_t dimension);

/// A number at least x, at most x(1 + 2^−bits), with few digits; and one at most x. For x > 0; 0 for 0.
[[nodiscard]] Rational shortened_up(const Rational& x, unsigned bits);
[[nodiscard]] Rational shortened_down(const Rational& x, unsigned bits);

/// The greatest of d(p, S(τ_p))/R(τ_p) over the vertices, with about 20 correct digits, without error bounds: what the
/// hoop property bounds. 0 if a facet is degenerate. Precondition: dimension ≥ 1.
[[nodiscard]] Rational approximate_hoop(const EdgeGram<Rational>& simplex);

}  // namespace delcert
