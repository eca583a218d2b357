#pragma once

#include "proofs/formula/simplex_object.hpp"

namespace delcert {

/// Whether |√a − √b| ≤ √bound, for squares of lengths. Decided exactly.
[[nodiscard]] bool lengths_differ_by_at_most(const Rational& squared_a, const Rational& squared_b,
                                             const Rational& squared_bound);

/// Whether all corresponding edges differ by at most ξΔ(σ). Decided exactly.
/// Precondition: both have the same number of vertices, ξ ≥ 0.
[[nodiscard]] bool is_distortion_at_most(const SimplexObject& simplex, const SimplexObject& image, const Rational& xi);

/// The least ξ for which corresponding edges differ by at most ξΔ(σ), rounded up by at most 2⁻⁴⁰ of it; 0 for
/// congruent simplices. Precondition: as above, Δ(σ) > 0.
[[nodiscard]] Rational measured_distortion(const SimplexObject& simplex, const SimplexObject& image);

/// Δ(σ)².
[[nodiscard]] Rational squared_longest_edge_of(const SimplexObject& simplex);

}  // namespace delcert
