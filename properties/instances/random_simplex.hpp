#pragma once

#include <optional>
#include <set>
#include <vector>

#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {

/// Points of a non-degenerate k-simplex in ℝᵐ, from fat to thickness 2⁻¹⁰⁰ and below: generic, of small integers,
/// corners of cubes, a vertex near the hull of others, a cluster of vertices, axes squashed; some far from the origin,
/// some scaled by up to 2^±60. Nothing if the choices lead to a degenerate one. Precondition: 1 ≤ k ≤ m.
[[nodiscard]] std::optional<SimplexObject::Points> random_simplex(const Shape& shape, Choices& choices);

/// Exchanges the first vertex with the one of the largest altitude. Computed in doubles, without error bounds: for
/// nearly degenerate simplices it may be another.
void put_high_vertex_first(SimplexObject::Points& points);

/// The traits that can be seen in a simplex alone: thickness below 2⁻²⁰.
[[nodiscard]] std::set<Trait> traits_of(const SimplexObject& simplex);

/// Lists of points like this one, but simpler: the first at the origin, a coordinate or a point less, rounder or
/// smaller coordinates. `least_points`, `least_dimension`: what must be left.
[[nodiscard]] std::vector<SimplexObject::Points> simpler_points(const SimplexObject::Points& points,
                                                                std::size_t least_points, std::size_t least_dimension);

/// Other numbers than this one, simpler, of the same sign, none of them closer to 0 than the power of two just below it
/// in size: 1, 1/2, 1/4 … as far as that power, and numbers of few digits. None for 0.
[[nodiscard]] std::vector<Rational> simpler_numbers(const Rational& number);

/// k = 1 … 6, m = k … k + 3.
[[nodiscard]] std::vector<Shape> simplex_shapes();

}  // namespace delcert
