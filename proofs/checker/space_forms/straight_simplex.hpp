#pragma once

#include "proofs/checker/core/frame.hpp"

namespace delcert::checker {

/// An m-simplex between points in orthonormal coordinates of R^m. If it may be flat, its quantities are not known, and
/// nothing is decided of them.
template <class N>
class StraightSimplex {
 public:
  StraightSimplex(std::size_t m, const core::Lifts<N>& vertices) : m_(m), first_(vertices[0]) {
    const core::Frame<N> frame(0, m, vertices, 0);
    const N determinant = dot(frame.cofactors_of(1), frame.columns[0], m);
    const N inverse = N(1) / (N(2) * determinant);
    Vector<N> sum{};
    for (std::size_t k = 1; k <= m; ++k) {
      const Vector<N> cofactors = frame.cofactors_of(k);
      centre_ = add(centre_, squared_length(frame.columns[k - 1]) * inverse, cofactors);
      sum = add(sum, N(1), cofactors);
      inverse_altitude_ = maximum(inverse_altitude_, squared_length(cofactors));
    }
    inverse_altitude_ = maximum(inverse_altitude_, squared_length(sum));
    determinant_squared_ = square(determinant);
    radius_squared_ = squared_length(centre_);
    for (std::size_t a = 0; a <= m; ++a) {
      for (std::size_t b = 0; b < a; ++b) longest_ = maximum(longest_, squared_length(vertices[a] - vertices[b]));
    }
  }

  Vector<N> centre() const { return add(first_, N(1), centre_); }
  const N& radius_squared() const { return radius_squared_; }
  /// |x - c|^2 - R^2.
  N power(const Vector<N>& x) const {
    const Vector<N> y = x - first_;
    return squared_length(y) - N(2) * dot(y, centre_, m_);
  }
  /// |x - c| > R + delta.
  Verdict is_clear(const Vector<N>& x, const N& delta) const {
    return negation(at_most_root(power(x) - square(delta), N(4) * radius_squared_ * square(delta)));
  }
  /// The least altitude is at least t m (longest edge). That of vertex k is |determinant| / |its cofactors|.
  Verdict is_thick(const N& t) const {
    return less_equal(square(t * N(static_cast<int>(m_))) * longest_ * inverse_altitude_, determinant_squared_);
  }

 private:
  N squared_length(const Vector<N>& x) const {
    N sum = square(x[0]);
    for (std::size_t k = 1; k < m_; ++k) sum = sum + square(x[k]);
    return sum;
  }

  std::size_t m_;
  Vector<N> first_, centre_{};  // the circumcentre, from the first vertex
  N radius_squared_{0}, determinant_squared_{0}, longest_{0};
  N inverse_altitude_{0};  // the square of the greatest, times the square of the determinant
};

}  // namespace delcert::checker
