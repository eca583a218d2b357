#pragma once

#include <array>

#include "kernel/number/scalar.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// A symmetric m×m matrix of scalars.
template <class S, int m>
using Matrix = std::array<Vector<S, m>, static_cast<std::size_t>(m)>;

/// The inner product of a frame, ⟨x, y⟩ = xᵀGy, on one rung of the ladder. A Cartesian frame (G = I) costs nothing.
template <class S, int m>
class MetricOn {
 public:
  MetricOn(const Matrix<Rational, m>& gram, const Matrix<Rational, m>& adjugate, bool cartesian)
      : cartesian_(cartesian) {
    for (std::size_t row = 0; row < m; ++row) {
      for (std::size_t column = 0; column < m; ++column) {
        gram_[row][column] = scalar_from<S>(gram[row][column]);
        adjugate_[row][column] = scalar_from<S>(adjugate[row][column]);
      }
    }
    Rational determinant(0);
    for (std::size_t column = 0; column < m; ++column) determinant += gram[0][column] * adjugate[column][0];
    determinant_ = scalar_from<S>(determinant);
  }

  [[nodiscard]] S inner(const Vector<S, m>& a, const Vector<S, m>& b) const {
    return cartesian_ ? pairing(a, b) : pairing(a, applied(gram_, b));
  }

  [[nodiscard]] S squared_norm(const Vector<S, m>& a) const {
    if (cartesian_) {
      S result = square(a[0]);
      for (std::size_t axis = 1; axis < m; ++axis) result += square(a[axis]);
      return result;
    }
    return inner(a, a);
  }

  /// adj(G)ν: the vector that is orthogonal to the kernel of the covector ν, with ⟨adj(G)ν, x⟩ = det(G)·ν(x).
  [[nodiscard]] Vector<S, m> raised(const Vector<S, m>& covector) const {
    return cartesian_ ? covector : applied(adjugate_, covector);
  }
  [[nodiscard]] const S& determinant() const { return determinant_; }
  [[nodiscard]] bool is_cartesian() const { return cartesian_; }

 private:
  static Vector<S, m> applied(const Matrix<S, m>& matrix, const Vector<S, m>& x) {
    Vector<S, m> result;
    for (std::size_t row = 0; row < m; ++row) result[row] = pairing(matrix[row], x);
    return result;
  }

  Matrix<S, m> gram_;
  Matrix<S, m> adjugate_;
  S determinant_;
  bool cartesian_;
};

/// The rational inner product of a frame and what follows from it.
template <int m>
class FrameMetric {
 public:
  /// Throws InputError unless the Gram matrix is symmetric and positive definite.
  explicit FrameMetric(const Matrix<Rational, m>& gram);
  [[nodiscard]] static FrameMetric cartesian();

  [[nodiscard]] const Matrix<Rational, m>& gram() const { return gram_; }
  [[nodiscard]] const Rational& determinant() const { return determinant_; }
  /// (G⁻¹)_aa: a vector of length r has coordinate a at most r·√(G⁻¹)_aa in size.
  [[nodiscard]] Rational inverse_diagonal(std::size_t axis) const { return adjugate_[axis][axis] / determinant_; }
  [[nodiscard]] bool is_cartesian() const { return cartesian_; }

  /// Precondition for S = Interval: a `RoundingGuard` is alive.
  template <class S>
  [[nodiscard]] MetricOn<S, m> on() const {
    return MetricOn<S, m>(gram_, adjugate_, cartesian_);
  }

  /// Cartesian coordinates of x through the Cholesky factor in doubles, without error bounds.
  [[nodiscard]] Vector<double, m> approximate_cartesian(const Vector<double, m>& x) const;
  /// The inverse of that map, without error bounds.
  [[nodiscard]] Vector<double, m> approximate_frame(const Vector<double, m>& cartesian) const;

 private:
  Matrix<Rational, m> gram_;
  Matrix<Rational, m> adjugate_;
  Rational determinant_;
  Matrix<double, m> cholesky_;  // lower triangular, G = LLᵀ; Cartesian = Lᵀx
  bool cartesian_ = true;
};

}  // namespace delcert
