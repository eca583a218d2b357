#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// A matrix row by row.
template <class S>
using Dense = std::vector<S>;

[[nodiscard]] inline double magnitude(double x) { return std::fabs(x); }
[[nodiscard]] inline Rational magnitude(const Rational& x) { return absolute(x); }

/// The inverse of an n×n matrix, by elimination with row pivots; S = double, without error bounds, or Rational. None if
/// it has none (of doubles: if a pivot is 0).
template <class S>
[[nodiscard]] std::optional<Dense<S>> inverse_of(Dense<S> a, std::size_t n) {
  Dense<S> result(n * n, S(0));
  for (std::size_t k = 0; k < n; ++k) result[k * n + k] = S(1);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t row = k + 1; row < n; ++row) {
      if (magnitude(a[pivot * n + k]) < magnitude(a[row * n + k])) pivot = row;
    }
    if (!(magnitude(a[pivot * n + k]) > S(0))) return std::nullopt;
    if (pivot != k) {
      for (std::size_t column = 0; column < n; ++column) {
        std::swap(a[pivot * n + column], a[k * n + column]);
        std::swap(result[pivot * n + column], result[k * n + column]);
      }
    }
    const S scale = S(1) / a[k * n + k];
    for (std::size_t column = 0; column < n; ++column) {
      a[k * n + column] = a[k * n + column] * scale;
      result[k * n + column] = result[k * n + column] * scale;
    }
    for (std::size_t row = 0; row < n; ++row) {
      if (row == k || a[row * n + k] == S(0)) continue;
      const S factor = a[row * n + k];
      for (std::size_t column = 0; column < n; ++column) {
        a[row * n + column] = a[row * n + column] - factor * a[k * n + column];
        result[row * n + column] = result[row * n + column] - factor * result[k * n + column];
      }
    }
  }
  return result;
}

}  // namespace delcert
