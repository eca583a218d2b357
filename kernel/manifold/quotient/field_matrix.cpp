#include "kernel/manifold/quotient/field_matrix.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace delcert {

namespace {

/// Brings the rows, each longer than `columns` or as long, to reduced echelon form in their first columns, and returns
/// the product of the pivots with the sign of the permutation: 0 if there are fewer pivots than columns.
FieldElement eliminate(std::vector<FieldVector>& rows, std::size_t columns) {
  FieldElement result(1);
  for (std::size_t k = 0; k < columns; ++k) {
    std::size_t pivot = k;
    while (pivot < rows.size() && rows[pivot][k].is_zero()) ++pivot;
    if (pivot >= rows.size()) return FieldElement(0);
    if (pivot != k) {
      std::swap(rows[pivot], rows[k]);
      result = -result;
    }
    result *= rows[k][k];
    const FieldElement scale = FieldElement(1) / rows[k][k];
    for (FieldElement& entry : rows[k]) entry *= scale;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (row == k || rows[row][k].is_zero()) continue;
      const FieldElement factor = rows[row][k];
      for (std::size_t column = k; column < rows[row].size(); ++column) rows[row][column] -= factor * rows[k][column];
    }
  }
  return result;
}

std::vector<FieldVector> rows_of(const FieldMatrix& a, std::size_t size) {
  std::vector<FieldVector> result(size, FieldVector(size));
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) result[row][column] = a(row, column);
  }
  return result;
}

}  // namespace

FieldMatrix FieldMatrix::identity(std::size_t order) {
  FieldMatrix result(order);
  for (std::size_t k = 0; k < order; ++k) result(k, k) = FieldElement(1);
  return result;
}

FieldVector FieldMatrix::column(std::size_t column) const {
  FieldVector result;
  for (std::size_t row = 0; row < order_; ++row) result.push_back((*this)(row, column));
  return result;
}

FieldMatrix operator*(const FieldMatrix& a, const FieldMatrix& b) {
  FieldMatrix result(a.order_);
  for (std::size_t row = 0; row < a.order_; ++row) {
    for (std::size_t k = 0; k < a.order_; ++k) {
      if (a(row, k).is_zero()) continue;
      for (std::size_t column = 0; column < a.order_; ++column) result(row, column) += a(row, k) * b(k, column);
    }
  }
  return result;
}

FieldMatrix operator-(const FieldMatrix& a, const FieldMatrix& b) {
  FieldMatrix result(a.order_);
  for (std::size_t at = 0; at < a.entries_.size(); ++at) result.entries_[at] = a.entries_[at] - b.entries_[at];
  return result;
}

FieldVector operator*(const FieldMatrix& a, const FieldVector& x) {
  FieldVector result(a.order_);
  for (std::size_t row = 0; row < a.order_; ++row) {
    for (std::size_t column = 0; column < a.order_; ++column) result[row] += a(row, column) * x[column];
  }
  return result;
}

FieldMatrix transposed(const FieldMatrix& a) {
  FieldMatrix result(a.order());
  for (std::size_t row = 0; row < a.order(); ++row) {
    for (std::size_t column = 0; column < a.order(); ++column) result(column, row) = a(row, column);
  }
  return result;
}

FieldElement determinant(const FieldMatrix& a) {
  auto rows = rows_of(a, a.order());
  return eliminate(rows, a.order());
}

FieldElement trace(const FieldMatrix& a) {
  FieldElement result(0);
  for (std::size_t k = 0; k < a.order(); ++k) result += a(k, k);
  return result;
}

FieldMatrix inverse(const FieldMatrix& a) {
  const std::size_t n = a.order();
  auto rows = rows_of(a, n);
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < n; ++column) rows[row].push_back(FieldElement(row == column ? 1 : 0));
  }
  if (eliminate(rows, n).is_zero()) throw std::domain_error("inverse of a singular matrix");
  FieldMatrix result(n);
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < n; ++column) result(row, column) = rows[row][n + column];
  }
  return result;
}

bool is_identity(const FieldMatrix& a) { return a == FieldMatrix::identity(a.order()); }

bool is_positive_definite(const FieldMatrix& symmetric) {
  for (std::size_t size = 1; size <= symmetric.order(); ++size) {
    auto rows = rows_of(symmetric, size);
    if (eliminate(rows, size).sign() <= 0) return false;
  }
  return true;
}

FieldElement pairing(const FieldVector& a, const FieldVector& b) {
  FieldElement result(0);
  for (std::size_t at = 0; at < a.size(); ++at) result += a[at] * b[at];
  return result;
}

FieldVector common_kernel(const std::vector<FieldVector>& rows) {
  const std::size_t n = rows.size() + 1;
  FieldVector result;
  for (std::size_t left_out = 0; left_out < n; ++left_out) {
    FieldMatrix minor(n - 1);
    for (std::size_t row = 0; row + 1 < n; ++row) {
      for (std::size_t column = 0; column + 1 < n; ++column)
        minor(row, column) = rows[row][column < left_out ? column : column + 1];
    }
    const FieldElement cofactor = determinant(minor);
    result.push_back(left_out % 2 == 0 ? cofactor : -cofactor);
  }
  return result;
}

bool Precedes::operator()(const FieldVector& a, const FieldVector& b) const {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](const auto& x, const auto& y) { return precedes(x, y); });
}

bool Precedes::operator()(const FieldMatrix& a, const FieldMatrix& b) const {
  for (std::size_t row = 0; row < a.order(); ++row) {
    for (std::size_t column = 0; column < a.order(); ++column) {
      if (precedes(a(row, column), b(row, column))) return true;
      if (precedes(b(row, column), a(row, column))) return false;
    }
  }
  return false;
}

}  // namespace delcert
