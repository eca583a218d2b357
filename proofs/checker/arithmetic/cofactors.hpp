#pragma once

#include "proofs/checker/arithmetic/matrix.hpp"
#include "proofs/checker/arithmetic/square_matrix.hpp"

namespace delcert::checker {

/// The inverse by cofactors, as solution() looks for no pivots; of order 2, 3. Infinite if the determinant may be 0.
inline Matrix<Interval> inverse_by_cofactors(const Matrix<Interval>& a) {
  const std::size_t m = a.rows();
  SquareMatrix<Interval> square_of_a(m);
  for (std::size_t k = 0; k < a.size(); ++k) square_of_a(k / m, k % m) = a[k];
  const Interval unit = Interval(1) / square_of_a.leading_minor(m);
  Matrix<Interval> result(m, m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = 0; k < m; ++k) {
      SquareMatrix<Interval> rest(m - 1);
      for (std::size_t at = 0; at < (m - 1) * (m - 1); ++at) {
        const std::size_t row = at / (m - 1), column = at % (m - 1);
        rest(row, column) = square_of_a(row + (row >= k ? 1 : 0), column + (column >= i ? 1 : 0));
      }
      const Interval minor = rest.leading_minor(m - 1) * unit;
      result(i, k) = (i + k) % 2 == 0 ? minor : -minor;
    }
  }
  return result;
}

}  // namespace delcert::checker
