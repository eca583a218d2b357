#pragma once

#include "kernel/manifold/gluing/metric_field.hpp"
#include "kernel/simplex/cholesky.hpp"

namespace delcert {

/// The linear part A of a chart φ(x) = A(x − p): upper triangular with a positive diagonal, dyadic; and what follows
/// from it.
template <int m>
class AffineChart {
 public:
  /// Throws InputError unless the matrix is upper triangular with a positive diagonal.
  explicit AffineChart(const Matrix<Rational, m>& matrix);

  [[nodiscard]] const Matrix<Rational, m>& matrix() const { return matrix_; }
  /// A⁻¹, upper triangular.
  [[nodiscard]] const Matrix<Rational, m>& inverse() const { return inverse_; }
  /// B = AᵀA.
  [[nodiscard]] Matrix<Rational, m> gram() const;
  /// (B⁻¹)_kk: a vector v has |v_k| ≤ |Av|·√ of this.
  [[nodiscard]] Rational squared_stretch(std::size_t axis) const;

 private:
  Matrix<Rational, m> matrix_;
  Matrix<Rational, m> inverse_;
};

/// The transposed Cholesky factor of a positive definite matrix, made in doubles from the middles of the enclosures and
/// rounded to 30 binary digits of its largest entry; how good it is, is to be measured. The same on every machine: no
/// operation but +, −, ×, /, √. Throws Rejection where the matrix is not positive definite to that precision.
/// Precondition: rounding to nearest.
template <int m>
[[nodiscard]] AffineChart<m> rounded_chart(const Matrix<Interval, m>& gram);

/// The matrix on a rung of the ladder. For S = Interval a `RoundingGuard` is alive.
template <class S, std::size_t m>
[[nodiscard]] std::array<std::array<S, m>, m> matrix_on(const std::array<std::array<Rational, m>, m>& a) {
  std::array<std::array<S, m>, m> result;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) result[row][column] = scalar_from<S>(a[row][column]);
  }
  return result;
}

}  // namespace delcert
