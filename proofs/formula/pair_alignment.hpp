#pragma once

#include <vector>

#include "kernel/simplex/spectrum.hpp"
#include "proofs/formula/simplex_object.hpp"

namespace delcert {

/// How closely an isometry Φ can lay one simplex on another, both with vertex 0 in the origin.
template <class S>
struct Alignment {
  S matrix_error;  ///< encloses the least ‖P̃ − ΦP‖, and has an upper end that an isometry reaches
  S vertex_error;  ///< the same for the largest ‖p̃_i − Φp_i‖, the upper end by the same isometry
};

/// P and P̃ are taken from the triangular factors of the Gram matrices, so that lengths are enough. The isometry that is
/// exhibited is the polar factor of a numerically orthogonal matrix Q, which differs from Q by at most ‖QᵀQ − I‖; Q is
/// near the polar factor of P̃P⁻¹, as in the proof of lem:good.isometry. From below, whatever Φ is:
/// |s_j(P̃) − s_j(P)| ≤ ‖P̃ − ΦP‖ and |‖p̃_i‖ − ‖p_i‖| ≤ ‖p̃_i − Φp_i‖ ≤ ‖P̃ − ΦP‖.
///
/// Absent (undecided) where the rung cannot factor the matrices. On algebraic numbers it is there for k = 1 and for
/// congruent simplices only. Precondition: both have k + 1 vertices, k ≥ 1, and σ is not degenerate.
template <class S>
[[nodiscard]] Partial<Alignment<S>> alignment(Evaluation<S>& evaluation, const SimplexObject& simplex,
                                              const SimplexObject& image) = delete;
template <>
[[nodiscard]] Partial<Alignment<Interval>> alignment(Evaluation<Interval>& evaluation, const SimplexObject& simplex,
                                                     const SimplexObject& image);
template <>
[[nodiscard]] Partial<Alignment<BigInterval>> alignment(Evaluation<BigInterval>& evaluation,
                                                        const SimplexObject& simplex, const SimplexObject& image);
/// Absent: left to the rungs above.
template <>
[[nodiscard]] inline Partial<Alignment<Surd>> alignment(Evaluation<Surd>&, const SimplexObject&, const SimplexObject&) {
  return Partial<Alignment<Surd>>::absent(Verdict::undecided);
}
template <>
[[nodiscard]] Partial<Alignment<Algebraic>> alignment(Evaluation<Algebraic>& evaluation, const SimplexObject& simplex,
                                                      const SimplexObject& image);

}  // namespace delcert
