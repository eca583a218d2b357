#pragma once

#include <flint/fmpz.h>
#include <flint/fmpz_mat.h>

#include <cstddef>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// A dense matrix of integers, by FLINT.
class IntegerMatrix {
 public:
  IntegerMatrix(std::size_t rows, std::size_t columns);
  ~IntegerMatrix() { fmpz_mat_clear(matrix_); }
  IntegerMatrix(const IntegerMatrix&) = delete;
  IntegerMatrix& operator=(const IntegerMatrix&) = delete;

  [[nodiscard]] std::size_t rows() const { return static_cast<std::size_t>(fmpz_mat_nrows(matrix_)); }
  [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(fmpz_mat_ncols(matrix_)); }
  /// The entry, which is 0 at first. Precondition: row < rows(), column < columns().
  [[nodiscard]] fmpz* entry(std::size_t row, std::size_t column) {
    return fmpz_mat_entry(matrix_, static_cast<slong>(row), static_cast<slong>(column));
  }
  /// The diagonal of the Smith normal form without its zeros: d₁ | d₂ | … | d_r, positive, r the rank.
  [[nodiscard]] std::vector<Integer> invariant_factors() const;

 private:
  fmpz_mat_t matrix_;
};

}  // namespace delcert
