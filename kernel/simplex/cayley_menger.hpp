#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

#include "kernel/simplex/edge_gram.hpp"

namespace delcert {

/// The determinant without divisions, by expansion along rows over all sets of columns: 2ⁿ·n products, for small n.
/// Unlike an elimination it never fails, on intervals it is wider.
template <Scalar S>
[[nodiscard]] S determinant_by_expansion(const SymmetricMatrix<S>& matrix) {
  const std::size_t order = matrix.order();
  std::vector<S> minors(std::size_t{1} << order, S(0));  // of the first rows and the columns in the index
  minors[0] = S(1);
  for (std::size_t columns = 1; columns < minors.size(); ++columns) {
    const auto row = static_cast<std::size_t>(__builtin_popcountll(columns)) - 1;
    bool positive = true;
    S sum(0);
    for (std::size_t column = order; column-- > 0;) {  // the last of the columns has the sign + in the last row
      if ((columns >> column & 1U) == 0) continue;
      const S term = matrix(row, column) * minors[columns & ~(std::size_t{1} << column)];
      sum = positive ? sum + term : sum - term;
      positive = !positive;
    }
    minors[columns] = sum;
  }
  return minors.back();
}

/// The matrix of squared edge lengths.
template <Scalar S>
[[nodiscard]] SymmetricMatrix<S> squared_distance_matrix(const EdgeGram<S>& simplex) {
  SymmetricMatrix<S> result(simplex.vertex_count());
  for (std::size_t i = 0; i < simplex.vertex_count(); ++i) {
    for (std::size_t j = 0; j < i; ++j) result(i, j) = simplex.squared_edge(i, j);
  }
  return result;
}

/// The Cayley–Menger determinant: of the matrix of squared edge lengths bordered by a row and a column 0, 1, …, 1.
/// It is (−1)^{k+1} 2ᵏ det PᵀP = (−1)^{k+1} 2ᵏ (k! volume)², so 0 exactly for a degenerate simplex.
template <Scalar S>
[[nodiscard]] S cayley_menger_determinant(const EdgeGram<S>& simplex) {
  const std::size_t count = simplex.vertex_count();
  SymmetricMatrix<S> bordered(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) bordered(i, j) = simplex.squared_edge(i, j);
    bordered(count, i) = S(1);
  }
  return determinant_by_expansion(bordered);
}

/// The squared k-dimensional volume, 1 for a vertex.
template <Scalar S>
[[nodiscard]] S squared_volume(const EdgeGram<S>& simplex) {
  S scale(simplex.dimension() % 2 == 0 ? -1 : 1);
  for (std::size_t i = 1; i <= simplex.dimension(); ++i) scale = scale * S(2) * square(S(static_cast<int>(i)));
  return cayley_menger_determinant(simplex) / scale;
}

/// D(p, σ)² from the edge lengths alone, as a quotient of Cayley–Menger determinants. Nothing where the opposite facet
/// is not certainly non-degenerate. Precondition: dimension ≥ 1.
template <Scalar S>
[[nodiscard]] std::optional<S> squared_altitude_by_volumes(const EdgeGram<S>& simplex, std::size_t p) {
  if (simplex.dimension() == 0) throw std::invalid_argument("a vertex has no altitude");
  const S facet = cayley_menger_determinant(simplex.opposite_facet(p));
  if (!is_refuted(is_zero(facet))) return std::nullopt;
  return cayley_menger_determinant(simplex) / (S(-2) * facet);
}

/// R(σ)² from the edge lengths alone: −det(squared distances) / (2 · Cayley–Menger determinant). Nothing where the
/// simplex is not certainly non-degenerate.
template <Scalar S>
[[nodiscard]] std::optional<S> squared_circumradius_by_volumes(const EdgeGram<S>& simplex) {
  const S bordered = cayley_menger_determinant(simplex);
  if (!is_refuted(is_zero(bordered))) return std::nullopt;
  return determinant_by_expansion(squared_distance_matrix(simplex)) / (S(-2) * bordered);
}

}  // namespace delcert
