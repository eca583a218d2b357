#include "kernel/simplex/frame_metric.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "kernel/simplex/dimensions.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

Rational determinant_of(const std::vector<std::vector<Rational>>& a) {
  if (a.empty()) return Rational(1);
  Rational result(0);
  for (std::size_t column = 0; column < a.size(); ++column) {
    std::vector<std::vector<Rational>> minor;
    for (std::size_t row = 1; row < a.size(); ++row) {
      minor.push_back(a[row]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(column));
    }
    const Rational term = a[0][column] * determinant_of(minor);
    result += column % 2 == 0 ? term : -term;
  }
  return result;
}

template <int m>
Matrix<Rational, m> adjugate_of(const Matrix<Rational, m>& gram) {
  Matrix<Rational, m> result;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) {
      std::vector<std::vector<Rational>> minor;
      for (std::size_t r = 0; r < m; ++r) {
        if (r == column) continue;
        minor.emplace_back();
        for (std::size_t c = 0; c < m; ++c) {
          if (c != row) minor.back().push_back(gram[r][c]);
        }
      }
      const Rational cofactor = determinant_of(minor);
      result[row][column] = (row + column) % 2 == 0 ? cofactor : -cofactor;
    }
  }
  return result;
}

template <int m>
Matrix<double, m> approximate_cholesky(const Matrix<Rational, m>& gram) {
  Matrix<double, m> lower{};
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      double rest = approximate_double(gram[row][column]);
      for (std::size_t k = 0; k < column; ++k) rest -= lower[row][k] * lower[column][k];
      lower[row][column] = row == column ? std::sqrt(rest) : rest / lower[column][column];
    }
  }
  return lower;
}

}  // namespace

template <int m>
FrameMetric<m>::FrameMetric(const Matrix<Rational, m>& gram) : gram_(gram), adjugate_(adjugate_of<m>(gram)) {
  for (std::size_t order = 1; order <= m; ++order) {
    std::vector<std::vector<Rational>> leading;
    for (std::size_t row = 0; row < order; ++row) {
      leading.emplace_back(gram[row].begin(), gram[row].begin() + static_cast<std::ptrdiff_t>(order));
      for (std::size_t column = 0; column < order; ++column) {
        if (gram[row][column] != gram[column][row]) throw InputError("Gram matrix is not symmetric");
        cartesian_ = cartesian_ && gram[row][column] == Rational(row == column ? 1 : 0);
      }
    }
    determinant_ = determinant_of(leading);
    if (determinant_ <= Rational(0)) {
      throw InputError("Gram matrix is not positive definite: leading minor of order " + std::to_string(order));
    }
  }
  cholesky_ = approximate_cholesky<m>(gram_);
}

template <int m>
FrameMetric<m> FrameMetric<m>::cartesian() {
  Matrix<Rational, m> identity;
  for (std::size_t axis = 0; axis < m; ++axis) identity[axis][axis] = Rational(1);
  return FrameMetric(identity);
}

template <int m>
Vector<double, m> FrameMetric<m>::approximate_cartesian(const Vector<double, m>& x) const {
  if (cartesian_) return x;
  Vector<double, m> result{};
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = row; column < m; ++column) result[row] += cholesky_[column][row] * x[column];
  }
  return result;
}

template <int m>
Vector<double, m> FrameMetric<m>::approximate_frame(const Vector<double, m>& cartesian) const {
  if (cartesian_) return cartesian;
  Vector<double, m> result{};
  for (std::size_t back = 0; back < m; ++back) {
    const std::size_t row = m - 1 - back;
    double rest = cartesian[row];
    for (std::size_t column = row + 1; column < m; ++column) rest -= cholesky_[column][row] * result[column];
    result[row] = rest / cholesky_[row][row];
  }
  return result;
}

#define DELCERT_INSTANTIATE(m) template class FrameMetric<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
