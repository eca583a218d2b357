#pragma once

#include "proofs/checker/arithmetic/ball.hpp"
#include "proofs/checker/geometry/metric.hpp"

namespace delcert::checker {

// The linear model of the space of curvature K = 1, 0, -1: all x = (x_0, y) with x_0^2 + K |y|^2 = 1 (and x_0 > 0
// unless K = 1); o = (1, 0). Its conformal coordinates a = 2y / (1 + x_0). Formulas: docs/space-forms.md.

/// arctan(sqrt q) / sqrt q, 1, artanh(sqrt q) / sqrt q: exp_o^-1 of the point with conformal coordinates a is this at
/// |a|^2 / 4, times a. Precondition: q may be 0 or positive, and less than 1 for K = -1.
Interval logarithm_factor(int K, const Interval& q);
Ball logarithm_factor(int K, const Ball& q);

/// tan r, r, tanh r.
Ball tangent(int K, const Ball& r);
/// sin r, r, sinh r.
Ball sine(int K, const Ball& r);
/// 2 sin^2(r/2), r^2/2, 2 sinh^2(r/2).
Ball versed_sine(int K, const Ball& r);

/// exp_o v in the linear model.
Vector<Ball> exponential(int K, std::size_t m, const Vector<Ball>& v);

template <class N>
N squared(const Vector<N>& a, std::size_t m) {
  N sum = square(a[0]);
  for (std::size_t k = 1; k < m; ++k) sum = sum + square(a[k]);
  return sum;
}

/// K |a|^2 / 4.
template <class N>
N bend(int K, std::size_t m, const Vector<N>& a) {
  return K == 0 ? N(0) : N(K) * squared(a, m) / N(4);
}

/// The point with these conformal coordinates.
template <class N>
Vector<N> linear(int K, std::size_t m, const Vector<N>& a) {
  const N D = bend(K, m, a), unit = N(1) / (N(1) + D);
  Vector<N> x{};
  x[0] = (N(1) - D) * unit;
  for (std::size_t k = 0; k < m; ++k) x[k + 1] = a[k] * unit;
  return x;
}

template <class N>
Vector<N> conformal(std::size_t m, const Vector<N>& x) {
  const N unit = N(2) / (N(1) + x[0]);
  Vector<N> a{};
  for (std::size_t k = 0; k < m; ++k) a[k] = x[k + 1] * unit;
  return a;
}

/// F^-1 x, F the isometry that takes o to the point with conformal coordinates a, which is p in the linear model, and
/// moves the geodesic through both along itself.
template <class N>
Vector<N> seen_from(int K, std::size_t m, const Vector<N>& a, const Vector<N>& p, const Vector<N>& x) {
  Vector<N> result{};
  N along = p[1] * x[1];  // y.x_y
  for (std::size_t k = 1; k < m; ++k) along = along + p[k + 1] * x[k + 1];
  result[0] = K == 0 ? x[0] : p[0] * x[0] + N(K) * along;
  // a a^T / (2 + 2D) = a y^T / 2.
  const N step = K == 0 ? N(0) : N(K) * along / N(2);
  for (std::size_t k = 0; k < m; ++k) result[k + 1] = x[k + 1] - p[k + 1] * x[0] - a[k] * step;
  return result;
}
template <class N>
Vector<N> seen_from(int K, std::size_t m, const Vector<N>& a, const Vector<N>& x) {
  return seen_from(K, m, a, linear(K, m, a), x);
}

/// The squared geodesic length, from the squared length 4 sin^2(d/2), d^2, 4 sinh^2(d/2) of the chord, d < pi.
template <class N>
N unrolled(int K, const N& chord) {
  const N q = chord / (N(4) - N(K) * chord);  // tan^2 (d/2)
  return N(4) * q * square(logarithm_factor(K, q));
}

/// The squared distance of two points given by conformal coordinates, less than pi apart.
template <class N>
N squared_distance(int K, std::size_t m, const Vector<N>& a, const Vector<N>& b) {
  return unrolled(K, squared(b - a, m) / ((N(1) + bend(K, m, a)) * (N(1) + bend(K, m, b))));
}

}  // namespace delcert::checker
