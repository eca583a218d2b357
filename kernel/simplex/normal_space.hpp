#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "kernel/simplex/circumsphere.hpp"

namespace delcert {

/// An affine space in coordinates: `base` plus the span of the (independent) directions.
template <Scalar S>
struct AffineSpace {
  std::vector<S> base;
  std::vector<std::vector<S>> directions;
};

namespace detail {
/// A basis of {x : row · x = 0 for all rows}, by Gauss–Jordan with complete pivoting on entries that are certainly not
/// 0. Undecided when what is left of the rows may or may not be 0.
template <Scalar S>
[[nodiscard]] Partial<std::vector<std::vector<S>>> kernel_basis(std::vector<std::vector<S>> rows, std::size_t width) {
  std::vector<std::pair<std::size_t, std::size_t>> pivots;
  std::vector<bool> row_used(rows.size(), false);
  std::vector<bool> column_used(width, false);
  const auto next_pivot = [&]() {
    std::pair<std::size_t, std::size_t> best{rows.size(), width};
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (std::size_t column = 0; column < width && !row_used[row]; ++column) {
        if (column_used[column] || !is_refuted(is_zero(rows[row][column]))) continue;
        if (best.first == rows.size() ||
            is_proved(less(square(rows[best.first][best.second]), square(rows[row][column])))) {
          best = {row, column};
        }
      }
    }
    return best;
  };
  for (auto pivot = next_pivot(); pivot.first != rows.size(); pivot = next_pivot()) {
    row_used[pivot.first] = column_used[pivot.second] = true;
    pivots.push_back(pivot);
    const std::vector<S>& source = rows[pivot.first];
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (row == pivot.first) continue;
      const S multiplier = rows[row][pivot.second] / source[pivot.second];
      for (std::size_t column = 0; column < width; ++column) {
        if (!column_used[column]) rows[row][column] = rows[row][column] - multiplier * source[column];
      }
      rows[row][pivot.second] = S(0);
    }
  }
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < width && !row_used[row]; ++column) {
      if (!column_used[column] && !is_proved(is_zero(rows[row][column]))) {
        return Partial<std::vector<std::vector<S>>>::absent(Verdict::undecided);
      }
    }
  }
  std::vector<std::vector<S>> basis;
  for (std::size_t free = 0; free < width; ++free) {
    if (column_used[free]) continue;
    std::vector<S> direction(width, S(0));
    direction[free] = S(1);
    for (const auto& [row, column] : pivots) direction[column] = S(0) - rows[row][free] / rows[row][column];
    basis.push_back(std::move(direction));
  }
  return basis;
}
}  // namespace detail

/// N(σ), the centres of all circumscribing balls of the simplex with the given vertices in a frame with the inner
/// product xᵀGy: through C(σ), orthogonal to aff σ, of dimension m − dim aff σ (section 4.2). Absent where there is no
/// circumcentre (refuted) or the simplex may be degenerate on intervals (undecided).
template <Scalar S>
[[nodiscard]] Partial<AffineSpace<S>> normal_space(const std::vector<std::vector<S>>& points,
                                                   const SymmetricMatrix<S>& metric) {
  const auto sphere = circumsphere(edge_gram_from_points(points, metric));
  if (!sphere) return Partial<AffineSpace<S>>::absent(sphere.exists());
  const std::size_t width = points[0].size();
  std::vector<std::vector<S>> covectors;  // G(p_i − p_0)
  for (std::size_t i = 1; i < points.size(); ++i) {
    std::vector<S> covector(width, S(0));
    for (std::size_t row = 0; row < width; ++row) {
      for (std::size_t column = 0; column < width; ++column) {
        covector[row] = covector[row] + metric(row, column) * (points[i][column] - points[0][column]);
      }
    }
    covectors.push_back(std::move(covector));
  }
  auto directions = detail::kernel_basis(std::move(covectors), width);
  if (!directions) return Partial<AffineSpace<S>>::absent(directions.exists());
  return AffineSpace<S>{circumcentre(*sphere, points), std::move(*directions)};
}

/// N(σ) in Cartesian coordinates.
template <Scalar S>
[[nodiscard]] Partial<AffineSpace<S>> normal_space(const std::vector<std::vector<S>>& points) {
  return normal_space(points, SymmetricMatrix<S>::identity(points.at(0).size()));
}

}  // namespace delcert
