#pragma once

#include <cstddef>

#include "kernel/simplex/bisection.hpp"
#include "kernel/simplex/edge_gram.hpp"
#include "kernel/simplex/gram_elimination.hpp"
#include "kernel/simplex/inertia.hpp"

namespace delcert {

// The singular values s_1 ≥ … ≥ s_k of P, whose columns are the edge vectors p_i − p_0 (section 4.1). They depend on
// which vertex comes first. Bounds come as squares t², so that the matrices tested are rational where the simplex is.

/// s_k(P) ≥ t: PᵀP − t²I is positive semidefinite. True for a vertex, whose P has no columns.
template <Scalar S>
[[nodiscard]] Verdict is_smallest_singular_value_at_least(const EdgeGram<S>& simplex, const S& squared_bound) {
  return GramElimination<S>(simplex.gram().shifted(S(0) - squared_bound)).semidefinite();
}

/// s_1(P) ≤ t: t²I − PᵀP is positive semidefinite.
template <Scalar S>
[[nodiscard]] Verdict is_largest_singular_value_at_most(const EdgeGram<S>& simplex, const S& squared_bound) {
  return GramElimination<S>(simplex.gram().negated().shifted(squared_bound)).semidefinite();
}

/// s_index(P) ≥ t for 1 ≤ index ≤ k: at least `index` eigenvalues of PᵀP − t²I are not negative.
template <Scalar S>
[[nodiscard]] Verdict is_singular_value_at_least(const EdgeGram<S>& simplex, std::size_t index,
                                                 const S& squared_bound) {
  const auto signs = inertia(simplex.gram().shifted(S(0) - squared_bound));
  return signs ? verdict_of(signs->positive + signs->zero >= index) : Verdict::undecided;
}

/// Bounds of s_index(P), 1 ≤ index ≤ k, by bisection with the inertia: upper − lower ≤ 2^−bits · upper, and exactly
/// [0, 0] when the value is 0. The comparisons climb the ladder.
[[nodiscard]] RationalBounds singular_value_bounds(const EdgeGram<Rational>& simplex, std::size_t index, unsigned bits);

}  // namespace delcert
