#pragma once

#include <string>
#include <vector>

#include "kernel/manifold/quotient/number_field.hpp"

namespace delcert {

using FieldVector = std::vector<FieldElement>;

/// A square matrix over a number field, of any order. Exact.
class FieldMatrix {
 public:
  /// 0.
  explicit FieldMatrix(std::size_t order = 0) : order_(order), entries_(order * order) {}
  [[nodiscard]] static FieldMatrix identity(std::size_t order);

  [[nodiscard]] std::size_t order() const { return order_; }
  [[nodiscard]] const FieldElement& operator()(std::size_t row, std::size_t column) const {
    return entries_[row * order_ + column];
  }
  [[nodiscard]] FieldElement& operator()(std::size_t row, std::size_t column) {
    return entries_[row * order_ + column];
  }
  [[nodiscard]] FieldVector column(std::size_t column) const;

  friend FieldMatrix operator*(const FieldMatrix& a, const FieldMatrix& b);
  friend FieldMatrix operator-(const FieldMatrix& a, const FieldMatrix& b);
  friend FieldVector operator*(const FieldMatrix& a, const FieldVector& x);
  friend bool operator==(const FieldMatrix& a, const FieldMatrix& b) = default;

 private:
  std::size_t order_;
  FieldVector entries_;
};

[[nodiscard]] FieldMatrix transposed(const FieldMatrix& a);
[[nodiscard]] FieldElement determinant(const FieldMatrix& a);
[[nodiscard]] FieldElement trace(const FieldMatrix& a);
/// Throws std::domain_error if a is singular.
[[nodiscard]] FieldMatrix inverse(const FieldMatrix& a);
[[nodiscard]] bool is_identity(const FieldMatrix& a);
/// Whether the symmetric matrix is positive definite: whether all leading minors are positive.
[[nodiscard]] bool is_positive_definite(const FieldMatrix& symmetric);

/// Σ aᵢbᵢ. Precondition: of the same length.
[[nodiscard]] FieldElement pairing(const FieldVector& a, const FieldVector& b);

/// The vector x, unique up to a factor, with row·x = 0 for these n − 1 rows of length n; 0 if they are dependent.
[[nodiscard]] FieldVector common_kernel(const std::vector<FieldVector>& rows);

/// Orders of representations, for containers.
struct Precedes {
  bool operator()(const FieldVector& a, const FieldVector& b) const;
  bool operator()(const FieldMatrix& a, const FieldMatrix& b) const;
};

}  // namespace delcert
