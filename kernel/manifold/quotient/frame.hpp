#pragma once

#include "kernel/chart/model_space.hpp"

namespace delcert {

/// The frame F_p of `model_frame` and its inverse, kept as what they are made of, so that applying one costs about two
/// scalar products, and nothing of size |a|² cancels where p is close to −o on the sphere.
///
/// S is a rung of the ladder: enclosures, or exact on `Rational`. For S = Interval a `RoundingGuard` must be alive.
template <class S, int m>
class Frame {
 public:
  /// The identity of 𝔼ᵐ.
  Frame() { point_[0] = S(1); }
  /// Of the point with conformal coordinates a; precondition for negative curvature: |a| < 2.
  Frame(Curvature curvature, const Vector<S, m>& a)
      : curvature_(curvature), conformal_(a), point_(model_point<S, m>(curvature, a)) {
    if (curvature == Curvature::zero) return;
    const S deviation = detail::conformal_deviation(curvature, a);
    bend_ = detail::times(curvature, S(1) / (S(2) + deviation + deviation));
  }

  /// p = F_p(o).
  [[nodiscard]] const ModelPoint<S, m>& point() const { return point_; }

  /// F_p(x).
  [[nodiscard]] ModelPoint<S, m> applied(const ModelPoint<S, m>& x) const { return moved<true>(x); }
  /// F_p⁻¹(x).
  [[nodiscard]] ModelPoint<S, m> inverse_applied(const ModelPoint<S, m>& x) const { return moved<false>(x); }
  /// The conformal coordinates of F_p⁻¹(x). In hyperbolic space, where the coordinates of points far from o are large
  /// and those of F_p⁻¹(x) are differences of their products, by a difference of conformal coordinates, which are less
  /// than 2: with α, β half of those of p and x, δ = β − α, σ = 1 − |α|² they are
  ///   2·(σδ − |δ|²α)/(σ² − 2σ α·δ + |α|²|δ|²).
  [[nodiscard]] Vector<S, m> conformal_seen(const ModelPoint<S, m>& x) const {
    if (curvature_ != Curvature::negative) return conformal_coordinates<S, m>(inverse_applied(x));
    const auto alpha = scaled(S(1) / S(2), conformal_);
    const auto beta = scaled(S(1) / (S(1) + x[0]), detail::spatial_part<S, static_cast<std::size_t>(m)>(x));
    const auto delta = difference(beta, alpha);
    const S alpha_squared = detail::sum_of_squares(alpha);
    const S delta_squared = detail::sum_of_squares(delta);
    const S sigma = S(1) - alpha_squared;
    const S across = sigma * pairing(alpha, delta);
    const S denominator = square(sigma) - (across + across) + alpha_squared * delta_squared;
    return scaled(S(2) / denominator, difference(scaled(sigma, delta), scaled(delta_squared, alpha)));
  }

 private:
  /// F of a, or of −a, which changes the signs of what is odd in a.
  template <bool forwards>
  [[nodiscard]] ModelPoint<S, m> moved(const ModelPoint<S, m>& x) const {
    ModelPoint<S, m> result;
    if (curvature_ == Curvature::zero) {
      result[0] = x[0];
      for (std::size_t axis = 1; axis <= m; ++axis) {
        const S step = point_[axis] * x[0];
        result[axis] = forwards ? x[axis] + step : x[axis] - step;
      }
      return result;
    }
    S across = point_[1] * x[1];
    S along = conformal_[0] * x[1];
    for (std::size_t axis = 1; axis < m; ++axis) {
      across += point_[axis + 1] * x[axis + 1];
      along += conformal_[axis] * x[axis + 1];
    }
    const bool adds = forwards == (curvature_ == Curvature::negative);
    result[0] = adds ? point_[0] * x[0] + across : point_[0] * x[0] - across;
    const S turn = bend_ * along;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const S step = point_[axis + 1] * x[0];
      const S rest = x[axis + 1] - turn * conformal_[axis];
      result[axis + 1] = forwards ? rest + step : rest - step;
    }
    return result;
  }

  Curvature curvature_ = Curvature::zero;
  Vector<S, m> conformal_{};
  ModelPoint<S, m> point_{};
  S bend_{};  // K/(2 + 2D)
};

}  // namespace delcert
