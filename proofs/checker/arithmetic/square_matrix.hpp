#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "proofs/checker/arithmetic/number_field.hpp"

namespace delcert::checker {

/// A square matrix of order at most 4.
template <class E>
class SquareMatrix {
 public:
  explicit SquareMatrix(std::size_t order = 0) : order_(order) {
    if constexpr (!is_small) entries_.resize(order * order);
  }
  static SquareMatrix identity(std::size_t order) {
    SquareMatrix result(order);
    for (std::size_t k = 0; k < order; ++k) result(k, k) = E(1);
    return result;
  }

  std::size_t order() const { return order_; }
  E& operator()(std::size_t i, std::size_t k) { return entries_[i * order_ + k]; }
  const E& operator()(std::size_t i, std::size_t k) const { return entries_[i * order_ + k]; }

  SquareMatrix transposed() const {
    SquareMatrix result(order_);
    for (std::size_t i = 0; i < order_; ++i) {
      for (std::size_t k = 0; k < order_; ++k) result(k, i) = (*this)(i, k);
    }
    return result;
  }
  friend SquareMatrix operator*(const SquareMatrix& a, const SquareMatrix& b) {
    SquareMatrix result(a.order_);
    for (std::size_t i = 0; i < a.order_; ++i) {
      for (std::size_t k = 0; k < a.order_; ++k) {
        for (std::size_t j = 0; j < a.order_; ++j) result(i, k) = result(i, k) + a(i, j) * b(j, k);
      }
    }
    return result;
  }
  /// The matrix times the first entries of x; the others stay.
  template <class X>
  X operator*(const X& x) const {
    X result = x;
    for (std::size_t i = 0; i < order_; ++i) {
      E sum(0);
      for (std::size_t k = 0; k < order_; ++k) sum = sum + (*this)(i, k) * x[k];
      result[i] = sum;
    }
    return result;
  }
  friend SquareMatrix operator+(const SquareMatrix& a, const SquareMatrix& b) {
    SquareMatrix result = a;
    for (std::size_t at = 0; at < a.entries_.size(); ++at) result.entries_[at] = a.entries_[at] + b.entries_[at];
    return result;
  }
  friend bool operator==(const SquareMatrix& a, const SquareMatrix& b) { return a.entries_ == b.entries_; }
  /// An order of representations, for containers.
  friend bool operator<(const SquareMatrix& a, const SquareMatrix& b) {
    return std::lexicographical_compare(a.entries_.begin(), a.entries_.end(), b.entries_.begin(), b.entries_.end());
  }

  /// The determinant of the first `size` rows and columns, by the first row.
  E leading_minor(std::size_t size) const { return minor_of(0, (1U << size) - 1); }

 private:
  /// Of the rows from this one on, and of columns, as bits.
  E minor_of(std::size_t row, unsigned columns) const {
    if (columns == 0) return E(1);
    E sum(0);
    bool even = true;
    for (std::size_t k = 0; k < order_; ++k) {
      if ((columns >> k & 1U) == 0) continue;
      const E term = (*this)(row, k) * minor_of(row + 1, columns & ~(1U << k));
      sum = even ? sum + term : sum - term;
      even = !even;
    }
    return sum;
  }

  static constexpr bool is_small = std::is_same_v<E, Interval>;
  std::size_t order_;
  std::conditional_t<is_small, std::array<E, 16>, std::vector<E>> entries_{};
};

/// Whether all leading minors of a symmetric matrix are positive: whether it is positive definite.
template <class E>
Verdict is_positive_definite(const SquareMatrix<E>& a) {
  Verdict result = Verdict::proved;
  for (std::size_t size = 1; size <= a.order(); ++size) result = conjunction(result, less(E(0), a.leading_minor(size)));
  return result;
}
inline Verdict less(const FieldElement& a, const FieldElement& b) { return verdict((b - a).sign() > 0); }

using FieldMatrix = SquareMatrix<FieldElement>;

/// Gauss and Jordan. Precondition: a is not singular.
inline FieldMatrix inverse_of(FieldMatrix a) {
  const std::size_t n = a.order();
  FieldMatrix result = FieldMatrix::identity(n);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (a(pivot, k).is_zero()) ++pivot;
    for (std::size_t j = 0; j < n; ++j) {
      std::swap(a(k, j), a(pivot, j));
      std::swap(result(k, j), result(pivot, j));
    }
    const FieldElement unit = FieldElement(1) / a(k, k);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || a(i, k).is_zero()) continue;
      const FieldElement factor = a(i, k) * unit;
      for (std::size_t j = 0; j < n; ++j) {
        a(i, j) = a(i, j) - factor * a(k, j);
        result(i, j) = result(i, j) - factor * result(k, j);
      }
    }
    for (std::size_t j = 0; j < n; ++j) {
      a(k, j) = a(k, j) * unit;
      result(k, j) = result(k, j) * unit;
    }
  }
  return result;
}

}  // namespace delcert::checker
