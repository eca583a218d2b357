#include "kernel/manifold/gluing/affine_chart.hpp"

#include <cmath>

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr int digits = 30;

}  // namespace

template <int m>
AffineChart<m>::AffineChart(const Matrix<Rational, m>& matrix) : matrix_(matrix) {
  for (std::size_t row = 0; row < m; ++row) {
    if (matrix_[row][row] <= Rational(0))
      throw InputError("the matrix of a chart has " + exact_text(matrix_[row][row]) + " on its diagonal");
    for (std::size_t column = 0; column < row; ++column) {
      if (matrix_[row][column] != Rational(0)) throw InputError("the matrix of a chart is not upper triangular");
    }
  }
  for (std::size_t column = 0; column < m; ++column) {
    inverse_[column][column] = Rational(1) / matrix_[column][column];
    for (std::size_t row = column; row-- > 0;) {
      Rational sum(0);
      for (std::size_t k = row + 1; k <= column; ++k) sum += matrix_[row][k] * inverse_[k][column];
      inverse_[row][column] = -sum / matrix_[row][row];
    }
  }
}

template <int m>
Matrix<Rational, m> AffineChart<m>::gram() const {
  Matrix<Rational, m> result;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) {
      for (std::size_t k = 0; k <= std::min(row, column); ++k)
        result[row][column] += matrix_[k][row] * matrix_[k][column];
    }
  }
  return result;
}

template <int m>
Rational AffineChart<m>::squared_stretch(std::size_t axis) const {
  // B⁻¹ = A⁻¹A⁻ᵀ.
  Rational result(0);
  for (std::size_t column = axis; column < m; ++column) result += square(inverse_[axis][column]);
  return result;
}

template <int m>
AffineChart<m> rounded_chart(const Matrix<Interval, m>& gram) {
  Matrix<double, m> factor{};
  double largest = 0;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = row; column < m; ++column) {
      const Interval& entry = gram[row][column];
      double rest = entry.lower() + (entry.upper() - entry.lower()) / 2;
      for (std::size_t k = 0; k < row; ++k) rest -= factor[k][row] * factor[k][column];
      if (column == row && !(rest > 0)) throw Rejection("a metric is not positive definite to double precision");
      factor[row][column] = column == row ? std::sqrt(rest) : rest / factor[row][row];
      largest = std::max(largest, std::fabs(factor[row][column]));
    }
  }
  const double step = std::ldexp(1.0, std::ilogb(largest) + 1 - digits);
  Matrix<Rational, m> matrix;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = row; column < m; ++column)
      matrix[row][column] = Rational::exactly(std::nearbyint(factor[row][column] / step) * step);
    if (matrix[row][row] <= Rational(0)) throw Rejection("a metric is not positive definite to 30 binary digits");
  }
  return AffineChart<m>(matrix);
}

#define DELCERT_INSTANTIATE(m)   \
  template class AffineChart<m>; \
  template AffineChart<m> rounded_chart<m>(const Matrix<Interval, m>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
