#pragma once

#include "kernel/chart/curved_functions.hpp"
#include "kernel/number/rational.hpp"

namespace delcert {

// How much distances differ between exponential charts exp_p⁻¹, exp_q⁻¹ and the space of constant curvature K that they
// show: docs/distortion.md has the formulas and proofs. All bounds are certified. Needs rounding to nearest.

/// r/sin r, 1, sinh r/r: on the ball of radius r a chart and the space differ by at most this factor. An upper bound.
/// Precondition: r ≥ 0, and r < π/2 for positive curvature.
[[nodiscard]] double chart_stretch(Curvature curvature, const Rational& radius);

/// η of the ball of this radius (thm:output.del.cplx): |d_X − d_chart| ≤ η·d_chart there. An upper bound of 1 − sin
/// r/r, 0, sinh r/r − 1, which are attained. Precondition as above.
[[nodiscard]] double metric_distortion(Curvature curvature, const Rational& radius);

/// The points at a distance of at most `from_first` from p and `from_second` from q, where d(p, q) ≤ `centres`.
struct Overlap {
  double from_first = 0;
  double from_second = 0;
  double centres = 0;
};

/// Bounds of a supremum, from both sides.
struct Enclosed {
  double lower = 0;
  double upper = 0;
};

/// How much exp_q⁻¹ ∘ exp_p stretches tangent vectors at most, over the overlap and over all such p and q: the supremum
/// of the largest singular value of its differential. The bounds differ by 2⁻¹⁰ of what they exceed 1 by, or a little
/// more where that is tiny. Precondition: radii are at most 3, and below π/2 for positive curvature.
[[nodiscard]] Enclosed greatest_stretch(Curvature curvature, const Overlap& overlap);

/// ξ of the transitions between patches of one radius R (hyps:input): ||φ(x)−φ(y)| − |x−y|| ≤ ξ|x−y| for all x, y in
/// the overlap of two patches.
struct TransitionDistortion {
  double proved = 0;  ///< of all pairs of patches: R/sin R − 1, 0, sinh R/R − 1, rounded up
  Enclosed of_pairs;  ///< the least ξ for all pairs at a distance of at most `centres`; some pair at it needs `lower`
};

/// Precondition: 0 ≤ centres ≤ 2R/3, R ≤ 3, and R < π/2 for positive curvature. Where K = 1 and R > 6/5 no more is
/// known from above than `proved`.
[[nodiscard]] TransitionDistortion transition_distortion(Curvature curvature, const Rational& patch_radius,
                                                         const Rational& centres);

/// The same for x, y in the image of the ball B(p, radius) alone, and all q with d(p, q) ≤ centres: an upper bound.
/// Precondition: radius + centres ≤ 3, and s·(radius + centres) < π/2 for positive curvature, s its chart_stretch;
/// where that fails, infinity.
[[nodiscard]] double ball_distortion(Curvature curvature, const Rational& radius, const Rational& centres);

}  // namespace delcert
