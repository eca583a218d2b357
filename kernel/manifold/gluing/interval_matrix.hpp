#pragma once

#include <array>
#include <cstddef>

#include "kernel/number/interval.hpp"

namespace delcert {

// Small square matrices of intervals, rows first. All needs a `RoundingGuard`.

template <std::size_t m>
using IntervalMatrix = std::array<std::array<Interval, m>, m>;

template <std::size_t m>
[[nodiscard]] IntervalMatrix<m> product(const IntervalMatrix<m>& a, const IntervalMatrix<m>& b) {
  IntervalMatrix<m> result;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) {
      result[row][column] = a[row][0] * b[0][column];
      for (std::size_t k = 1; k < m; ++k) result[row][column] += a[row][k] * b[k][column];
    }
  }
  return result;
}

/// aᵀa.
template <std::size_t m>
[[nodiscard]] IntervalMatrix<m> gram_of(const IntervalMatrix<m>& a) {
  IntervalMatrix<m> result;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) {
      result[row][column] = row == column ? square(a[0][row]) : a[0][row] * a[0][column];
      for (std::size_t k = 1; k < m; ++k)
        result[row][column] += row == column ? square(a[k][row]) : a[k][row] * a[k][column];
    }
  }
  return result;
}

template <std::size_t m>
[[nodiscard]] std::array<Interval, m> applied(const IntervalMatrix<m>& a, const std::array<Interval, m>& x) {
  std::array<Interval, m> result;
  for (std::size_t row = 0; row < m; ++row) {
    result[row] = a[row][0] * x[0];
    for (std::size_t k = 1; k < m; ++k) result[row] += a[row][k] * x[k];
  }
  return result;
}

/// By cofactors; unbounded where the determinant may be 0. m = 2, 3.
template <std::size_t m>
[[nodiscard]] IntervalMatrix<m> inverse_of(const IntervalMatrix<m>& a) {
  static_assert(m == 2 || m == 3);
  IntervalMatrix<m> result;
  if constexpr (m == 2) {
    const Interval determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    return {{{a[1][1] / determinant, -a[0][1] / determinant}, {-a[1][0] / determinant, a[0][0] / determinant}}};
  } else {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        result[k][i] = a[(i + 1) % 3][(k + 1) % 3] * a[(i + 2) % 3][(k + 2) % 3] -
                       a[(i + 1) % 3][(k + 2) % 3] * a[(i + 2) % 3][(k + 1) % 3];
    }
    const Interval determinant = a[0][0] * result[0][0] + a[0][1] * result[1][0] + a[0][2] * result[2][0];
    for (auto& row : result) {
      for (Interval& entry : row) entry = entry / determinant;
    }
  }
  return result;
}

/// An upper bound of |x|.
template <std::size_t m>
[[nodiscard]] double length_above(const std::array<Interval, m>& x) {
  Interval sum(0);
  for (const Interval& entry : x) sum += square(entry);
  return square_root(sum).upper();
}

/// An upper bound of the spectral norm: the fourth root of the sum of the squares of the entries of aᵀa.
template <std::size_t m>
[[nodiscard]] double norm_above(const IntervalMatrix<m>& a) {
  Interval sum(0);
  for (const auto& row : gram_of(a)) {
    for (const Interval& entry : row) sum += square(entry);
  }
  return square_root(square_root(sum)).upper();
}

}  // namespace delcert
