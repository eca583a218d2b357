#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

#include "kernel/simplex/bisection.hpp"
#include "kernel/simplex/gram_elimination.hpp"

namespace delcert {

/// ‖E‖ ≤ t for a symmetric matrix, without eigenvalues: tI − E and tI + E are positive semidefinite.
template <Scalar S>
[[nodiscard]] Verdict is_symmetric_norm_at_most(const SymmetricMatrix<S>& matrix, const S& bound) {
  const Verdict above = GramElimination<S>(matrix.negated().shifted(bound)).semidefinite();
  if (is_refuted(above)) return above;
  return conjunction(above, GramElimination<S>(matrix.shifted(bound)).semidefinite());
}

/// AᵀA for the matrix A with the given columns.
template <Scalar S>
[[nodiscard]] SymmetricMatrix<S> gram_of_columns(std::span<const std::vector<S>> columns) {
  SymmetricMatrix<S> result(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].size() != columns[0].size()) throw std::invalid_argument("columns of different lengths");
    for (std::size_t j = 0; j <= i; ++j) {
      S sum(0);
      for (std::size_t row = 0; row < columns[i].size(); ++row) {
        sum = sum + (i == j ? square(columns[i][row]) : columns[i][row] * columns[j][row]);
      }
      result(i, j) = sum;
    }
  }
  return result;
}

/// ‖A‖ ≤ t for any matrix, given by its columns: t²I − AᵀA is positive semidefinite. The bound comes as its square.
template <Scalar S>
[[nodiscard]] Verdict is_norm_at_most(std::span<const std::vector<S>> columns, const S& squared_bound) {
  return GramElimination<S>(gram_of_columns(columns).negated().shifted(squared_bound)).semidefinite();
}

/// Bounds of ‖E‖ for a symmetric matrix by bisection: upper − lower ≤ 2^−bits · upper; [0, 0] for E = 0.
[[nodiscard]] RationalBounds symmetric_norm_bounds(const SymmetricMatrix<Rational>& matrix, unsigned bits);

/// Bounds of ‖A‖ for a matrix given by its columns, likewise.
[[nodiscard]] RationalBounds norm_bounds(std::span<const std::vector<Rational>> columns, unsigned bits);

}  // namespace delcert
