#pragma once

#include <cstddef>

#include "kernel/simplex/edge_gram.hpp"
#include "kernel/simplex/gram_elimination.hpp"

namespace delcert {

/// Whether the vertices are affinely independent: the Gram matrix is positive definite. Proved for a vertex. On
/// intervals undecided when a pivot may be 0. Refuted also for edge lengths that no simplex has.
template <Scalar S>
[[nodiscard]] Verdict is_non_degenerate(const EdgeGram<S>& simplex) {
  return GramElimination<S>(simplex.gram()).definite();
}

/// Whether ℝᵐ has points with these edge lengths: the Gram matrix is positive semidefinite of rank at most m.
template <Scalar S>
[[nodiscard]] Verdict is_realisable(const EdgeGram<S>& simplex, std::size_t ambient_dimension) {
  const GramElimination<S> elimination(simplex.gram());
  if (elimination.pivot_count() > ambient_dimension) return Verdict::refuted;
  return elimination.semidefinite();
}

}  // namespace delcert
