#pragma once

#include "kernel/chart/curved_functions.hpp"
#include "kernel/simplex/frame_metric.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

// The model spaces in their linear model, all three by the same formulas (docs/space-forms.md). With K the curvature,
// points are the x = (x₀, y) in ℝ × ℝᵐ with x₀² + K|y|² = 1, x₀ > 0 unless K = 1; the origin is o = (1, 0).
//
// S is a rung of the ladder. Functions marked "rational" are exact on `Rational`; the others take `Interval` (which
// needs a `RoundingGuard`) and `BigInterval` and return enclosures. Vectors and conformal coordinates are Cartesian,
// but for K = 0, where they may belong to any frame.

/// A point of the linear model: x₀, then the m coordinates of y.
template <class S, int m>
using ModelPoint = Vector<S, m + 1>;

/// A linear map of the linear model, by rows.
template <class S, int m>
using ModelMatrix = Matrix<S, m + 1>;

namespace detail {

template <class S, std::size_t n>
[[nodiscard]] S sum_of_squares(const std::array<S, n>& a) {
  S result = square(a[0]);
  for (std::size_t axis = 1; axis < n; ++axis) result += square(a[axis]);
  return result;
}

/// x, 0 or −x.
template <class S>
[[nodiscard]] S times(Curvature curvature, const S& x) {
  return curvature == Curvature::zero ? S(0) : curvature == Curvature::positive ? x : S(0) - x;
}

/// K|a|²/4.
template <class S, std::size_t m>
[[nodiscard]] S conformal_deviation(Curvature curvature, const std::array<S, m>& a) {
  if (curvature == Curvature::zero) return S(0);
  return times(curvature, sum_of_squares(a) / S(4));
}

template <class S, std::size_t n>
[[nodiscard]] std::array<S, n> spatial_part(const std::array<S, n + 1>& x) {
  std::array<S, n> result;
  for (std::size_t axis = 0; axis < n; ++axis) result[axis] = x[axis + 1];
  return result;
}

}  // namespace detail

/// The point with Riemann's conformal coordinates a, in which the metric is |da|/(1 + K|a|²/4): a = 2·stereographic,
/// 2·Poincaré-ball or Cartesian coordinates, so |a| = 2 tan(d/2), 2 tanh(d/2), d for the distance d from o. Rational.
/// Precondition for K = −1: |a| < 2. Every point has such coordinates but −o on the sphere.
template <class S, int m>
[[nodiscard]] ModelPoint<S, m> model_point(Curvature curvature, const Vector<S, m>& a) {
  const S deviation = detail::conformal_deviation(curvature, a);
  ModelPoint<S, m> result;
  result[0] = (S(1) - deviation) / (S(1) + deviation);
  for (std::size_t axis = 0; axis < m; ++axis) result[axis + 1] = a[axis] / (S(1) + deviation);
  return result;
}

/// The frame F_p of the point p with conformal coordinates a: the isometry that takes o to p and moves the geodesic
/// through them along itself (parallel transport along it; a translation for K = 0). Its columns but the first are
/// an orthonormal basis of T_pX. Rational. F_p⁻¹ is the frame of −a.
template <class S, int m>
[[nodiscard]] ModelMatrix<S, m> model_frame(Curvature curvature, const Vector<S, m>& a) {
  const S deviation = detail::conformal_deviation(curvature, a);
  const ModelPoint<S, m> p = model_point<S, m>(curvature, a);
  ModelMatrix<S, m> result;
  result[0][0] = p[0];
  for (std::size_t row = 1; row <= m; ++row) {
    result[row][0] = p[row];
    result[0][row] = detail::times(curvature, S(0) - p[row]);
    for (std::size_t column = 1; column <= m; ++column) {
      const S bend = detail::times(curvature, a[row - 1] * a[column - 1]) / (S(2) + deviation + deviation);
      result[row][column] = S(row == column ? 1 : 0) - bend;
    }
  }
  return result;
}

/// F_p⁻¹. Rational.
template <class S, int m>
[[nodiscard]] ModelMatrix<S, m> inverse_model_frame(Curvature curvature, const Vector<S, m>& a) {
  return model_frame<S, m>(curvature, difference(Vector<S, m>{}, a));
}

/// A·x. Rational.
template <class S, std::size_t n>
[[nodiscard]] std::array<S, n> applied(const std::array<std::array<S, n>, n>& matrix, const std::array<S, n>& x) {
  std::array<S, n> result;
  for (std::size_t row = 0; row < n; ++row) result[row] = pairing(matrix[row], x);
  return result;
}

/// A·B. Rational.
template <class S, std::size_t n>
[[nodiscard]] std::array<std::array<S, n>, n> product(const std::array<std::array<S, n>, n>& a,
                                                      const std::array<std::array<S, n>, n>& b) {
  std::array<std::array<S, n>, n> result;
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < n; ++column) {
      S entry = a[row][0] * b[0][column];
      for (std::size_t k = 1; k < n; ++k) entry += a[row][k] * b[k][column];
      result[row][column] = entry;
    }
  }
  return result;
}

/// exp_o(v). Precondition for K = 1: |v| ≤ π, else the enclosure is wide.
template <class S, int m>
[[nodiscard]] ModelPoint<S, m> exponential(Curvature curvature, const Vector<S, m>& v) {
  ModelPoint<S, m> result;
  result[0] = S(1);
  S ratio(1);
  if (curvature != Curvature::zero) {
    const S squared = detail::sum_of_squares(v);
    result[0] = cosine_of_root(curvature, squared);
    ratio = sine_ratio(curvature, squared);
  }
  for (std::size_t axis = 0; axis < m; ++axis) result[axis + 1] = ratio * v[axis];
  return result;
}

/// The conformal coordinates of a point: a = 2y/(1 + x₀). Rational. Unbounded (on `Rational` std::domain_error) where
/// the point may be −o.
template <class S, int m>
[[nodiscard]] Vector<S, m> conformal_coordinates(const ModelPoint<S, m>& x) {
  const S factor = S(2) / (S(1) + x[0]);
  return scaled(factor, detail::spatial_part<S, static_cast<std::size_t>(m)>(x));
}

/// exp_o⁻¹ of the point with conformal coordinates a: a·(arctan √q/√q), q = |a|²/4. Its error is relative to |a|.
template <class S, int m>
[[nodiscard]] Vector<S, m> logarithm_of_conformal(Curvature curvature, const Vector<S, m>& a) {
  if (curvature == Curvature::zero) return a;
  return scaled(arctangent_ratio(curvature, detail::sum_of_squares(a) / S(4)), a);
}

/// exp_o⁻¹(x). Unbounded where x may be −o on the sphere.
template <class S, int m>
[[nodiscard]] Vector<S, m> logarithm(Curvature curvature, const ModelPoint<S, m>& x) {
  return logarithm_of_conformal<S, m>(curvature, conformal_coordinates<S, m>(x));
}

/// |x − y|² in the linear model: 4 sin²(d/2), d², 4 sinh²(d/2) for the distance d, without cancellation for points that
/// are close to each other. Rational. `metric` is that of the frame; Cartesian unless K = 0.
template <class S, int m>
[[nodiscard]] S squared_chord(Curvature curvature, const MetricOn<S, m>& metric, const ModelPoint<S, m>& x,
                              const ModelPoint<S, m>& y) {
  const ModelPoint<S, m> step = difference(x, y);
  const S spatial = metric.squared_norm(detail::spatial_part<S, static_cast<std::size_t>(m)>(step));
  return spatial + detail::times(curvature, square(step[0]));
}

/// The distance of two points with this squared chord, which is cut off below 0 (and above 4 for K = 1).
template <class S>
[[nodiscard]] S distance_of_chord(Curvature curvature, const S& squared) {
  const S chord = maximum(squared, S(0));
  if (curvature == Curvature::zero) return square_root(chord);
  // Beyond a right angle the distance from the antipode is the one that is well conditioned.
  if (curvature == Curvature::positive && is_proved(less(S(2), chord)))
    return straight_angle<S>() - distance_of_chord(curvature, S(4) - chord);
  const S cosine_squared = maximum(S(1) - detail::times(curvature, chord / S(4)), S(0));
  const S distance = square_root(chord / cosine_squared) * arctangent_ratio(curvature, chord / (S(4) * cosine_squared));
  return curvature == Curvature::positive ? minimum(distance, straight_angle<S>()) : distance;
}

}  // namespace delcert
