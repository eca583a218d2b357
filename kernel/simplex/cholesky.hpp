#pragma once

#include "kernel/simplex/frame_metric.hpp"

namespace delcert {

/// G = RᵀR with R upper triangular, enclosed: Rx are Cartesian coordinates of x. For a Cartesian frame R is exactly the
/// identity. Preconditions: the metric is that of the Gram matrix; a guard of the filter is alive.
template <class S, int m>
[[nodiscard]] Matrix<S, m> upper_factor(const MetricOn<S, m>& metric, const Matrix<Rational, m>& gram) {
  Matrix<S, m> result{};
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = row; column < m; ++column) {
      S rest = scalar_from<S>(gram[row][column]);
      for (std::size_t k = 0; k < row; ++k) rest -= result[k][row] * result[k][column];
      if (metric.is_cartesian()) {
        result[row][column] = rest;
      } else {
        result[row][column] = row == column ? square_root(rest) : rest / result[row][row];
      }
    }
  }
  return result;
}

/// Rx for an upper triangular R.
template <class S, std::size_t m>
[[nodiscard]] std::array<S, m> upper_applied(const std::array<std::array<S, m>, m>& factor, const std::array<S, m>& x) {
  std::array<S, m> result;
  for (std::size_t row = 0; row < m; ++row) {
    result[row] = factor[row][row] * x[row];
    for (std::size_t column = row + 1; column < m; ++column) result[row] += factor[row][column] * x[column];
  }
  return result;
}

}  // namespace delcert
