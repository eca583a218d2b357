#pragma once

#include <memory>
#include <optional>

#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/choices.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {

using SimplexPointer = std::shared_ptr<const SimplexObject>;

// Distorted copies σ̃ of a simplex. Each has |‖p_i − p_j‖ − ‖p̃_i − p̃_j‖| ≤ ξΔ(σ) for all edges, up to roundings that
// the caller finds by measuring, and comes near ξ where its choices let it. Precondition: ξ ≥ 0.

/// By a linear map with singular values in [1 − ξ, 1 + ξ], many of them at the ends, between two rational reflections.
/// Precondition: coordinates.
[[nodiscard]] SimplexPointer linear_image(const SimplexObject& simplex, const Rational& xi, Choices& choices);

/// By moving all vertices along given vectors, as far as ξ allows. Precondition: coordinates.
[[nodiscard]] SimplexPointer displaced_image(const SimplexObject& simplex, const SimplexObject::Points& directions,
                                             const Rational& xi);

/// Vectors of ℝᵐ for all vertices, with entries in [−1, 1).
[[nodiscard]] SimplexObject::Points random_directions(const SimplexObject& simplex, Choices& choices);

/// By changing the squares of the edge lengths only, most of them by ξΔ: known by its edges. With `by_star`, all edges
/// at vertex 0 one way and all others the other way. Pulled towards σ where no simplex has these lengths.
[[nodiscard]] SimplexPointer relengthened_image(const SimplexObject& simplex, const Rational& xi, bool by_star,
                                                Choices& choices);

/// By changing each squared edge by the same amount relative to its length, up or down by the sign of the product of
/// the barycentric coordinates λ_iλ_j of the circumcentre: R² is the greatest value of Σ λ_iλ_j|p_i − p_j|², so that to
/// first order the circumradius changes as much as ξ lets it. Precondition: not degenerate.
[[nodiscard]] SimplexPointer signed_image(const SimplexObject& simplex, const Rational& xi, Choices& choices);

/// The regular k-simplex with edges of length 1, known by its edges.
[[nodiscard]] SimplexPointer regular_simplex_by_edges(int k);

/// A rational orthogonal map of ℝᵐ, applied to points: reflection at the hyperplane orthogonal to a vector that is not
/// 0.
[[nodiscard]] std::vector<Rational> reflected(const std::vector<Rational>& point, const std::vector<Rational>& normal);

/// A vector of small integers, not 0.
[[nodiscard]] std::vector<Rational> random_normal(std::size_t dimension, Choices& choices);

/// A number of [−1, 1], mostly one of the ends.
[[nodiscard]] Rational random_share(Choices& choices);

}  // namespace delcert
