#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "kernel/number/scalar.hpp"

namespace delcert {

/// A symmetric matrix of any order, its lower triangle stored: (i, j) and (j, i) are one entry. Starts as 0.
template <Scalar S>
class SymmetricMatrix {
 public:
  explicit SymmetricMatrix(std::size_t order) : order_(order), entries_(order * (order + 1) / 2, S(0)) {}

  [[nodiscard]] std::size_t order() const { return order_; }
  [[nodiscard]] const S& operator()(std::size_t row, std::size_t column) const { return entries_[index(row, column)]; }
  [[nodiscard]] S& operator()(std::size_t row, std::size_t column) { return entries_[index(row, column)]; }

  [[nodiscard]] static SymmetricMatrix identity(std::size_t order) { return SymmetricMatrix(order).shifted(S(1)); }

  /// This matrix plus `shift` times the identity.
  [[nodiscard]] SymmetricMatrix shifted(const S& shift) const {
    SymmetricMatrix result = *this;
    for (std::size_t i = 0; i < order_; ++i) result(i, i) = result(i, i) + shift;
    return result;
  }
  [[nodiscard]] SymmetricMatrix negated() const {
    SymmetricMatrix result = *this;
    for (S& entry : result.entries_) entry = S(0) - entry;
    return result;
  }

 private:
  [[nodiscard]] static std::size_t index(std::size_t row, std::size_t column) {
    if (row < column) std::swap(row, column);
    return row * (row + 1) / 2 + column;
  }

  std::size_t order_;
  std::vector<S> entries_;
};

/// The exactly known matrix on another rung of the ladder.
template <Scalar S>
[[nodiscard]] SymmetricMatrix<S> matrix_from(const SymmetricMatrix<Rational>& exact) {
  SymmetricMatrix<S> result(exact.order());
  for (std::size_t row = 0; row < exact.order(); ++row) {
    for (std::size_t column = 0; column <= row; ++column) result(row, column) = scalar_from<S>(exact(row, column));
  }
  return result;
}

}  // namespace delcert
