#pragma once

#include <cstddef>
#include <vector>

#include "kernel/simplex/edge_gram.hpp"
#include "kernel/simplex/gram_elimination.hpp"
#include "kernel/simplex/partial.hpp"

namespace delcert {

/// D(p, σ)², the squared distance of vertex p from the affine hull of the opposite facet, by projection. It exists for
/// every simplex of dimension at least 1, degenerate or not; on intervals it is absent where the facet may be
/// degenerate.
template <Scalar S>
[[nodiscard]] Partial<S> squared_altitude(const EdgeGram<S>& simplex, std::size_t p) {
  if (simplex.dimension() == 0) throw std::invalid_argument("a vertex has no altitude");
  const std::size_t base = p == 0 ? 1 : 0;
  // Of the facet, from p_base: the Gram matrix, and ⟨p_i − p_base, p − p_base⟩.
  SymmetricMatrix<S> gram(simplex.dimension() - 1);
  std::vector<S> shadow;
  shadow.reserve(gram.order());
  for (std::size_t i = 0; i < simplex.vertex_count(); ++i) {
    if (i == p || i == base) continue;
    std::size_t column = 0;
    for (std::size_t j = 0; j <= i; ++j) {
      if (j != p && j != base) gram(shadow.size(), column++) = simplex.product(base, i, j);
    }
    shadow.push_back(simplex.product(base, i, p));
  }
  const auto projection = GramElimination<S>(std::move(gram)).energy(std::move(shadow));
  if (!projection) return Partial<S>::absent(projection.exists());
  return S(simplex.squared_edge(p, base) - *projection);
}

/// D(p, σ), on the rungs that have square roots; absent as `squared_altitude`.
template <Scalar S>
[[nodiscard]] Partial<S> altitude(const EdgeGram<S>& simplex, std::size_t p) {
  const Partial<S> squared = squared_altitude(simplex, p);
  return squared ? Partial<S>(square_root(*squared)) : squared;
}

/// All D(p, σ)⁻² from the dual basis (lem:bound.skP): the rows of the pseudo-inverse of P have the lengths 1/D(p_i, σ)
/// for i ≥ 1, and minus their sum has length 1/D(p_0, σ). Absent unless the simplex is certainly non-degenerate;
/// refuted if it is degenerate.
template <Scalar S>
[[nodiscard]] Partial<std::vector<S>> squared_dual_lengths(const EdgeGram<S>& simplex) {
  const GramElimination<S> elimination(simplex.gram());
  if (!is_proved(elimination.definite())) return Partial<std::vector<S>>::absent(elimination.definite());
  const std::size_t k = simplex.dimension();
  std::vector<S> result(k + 1, S(0));
  const auto energy_of = [&elimination](std::vector<S> b) { return *elimination.energy(std::move(b)); };
  result[0] = energy_of(std::vector<S>(k, S(1)));
  for (std::size_t i = 0; i < k; ++i) {
    std::vector<S> unit(k, S(0));
    unit[i] = S(1);
    result[i + 1] = energy_of(std::move(unit));
  }
  return result;
}

}  // namespace delcert
