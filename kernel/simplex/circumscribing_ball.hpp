#pragma once

#include <cstddef>

#include "kernel/simplex/sphere_distance.hpp"

namespace delcert {

/// Whether σ ⊂ ℝᵐ has *some* circumscribing ball B(C, R) with R < radius and ||p − C| − R| ≤ tolerance, for the point p
/// with the given offset against σ. `normal_dimension` is the dimension m − dim aff σ of the space of centres.
///
/// Derivation. Write C = C(σ) + n with n orthogonal to aff σ, so R² = R(σ)² + |n|², and u = |p − C|² − R² = w − 2⟨h, n⟩
/// with h the height vector of p and w = h² + ρ² − R(σ)². Let T² = radius² − R(σ)².
///
/// * Normal dimension 0: only n = 0, a test of the diametric sphere.
/// * Otherwise, let n run over 0 ≤ |n| < T. If u vanishes for one of them, that ball serves. If not, u has one sign,
/// and
///   ||p − C| − R| = |u|/(|p − C| + R) comes closest to 0 as |n| → T with ⟨h, n⟩ → ±hT of the sign that decreases |u|:
///   across h this is clear, since |p − C| and R grow while u stays; along h, |p − C| − R is the difference of the
///   distances from a moving point of a line to two points, so that on either side of its zero its size first grows
///   and then shrinks, or only one of these. The limit is not attained. With e = radius, t = tolerance:
///   |√(e² + u) − e| < t there, that is u < t² + 2et and (t > e or u > t² − 2et). So there is such a ball iff
///     R(σ) < e  and  [ h = 0 and w = 0,  or  w − t² < 2et + 2hT  and  (t > e  or  t² − w < 2et + 2hT) ].
///
/// Decided on squares, so that radius and tolerance come squared too. Exact on exact scalars.
/// Preconditions: normal_dimension ≥ 1 unless the height is 0.
template <Scalar S>
[[nodiscard]] Verdict has_circumscribing_ball_near(const SphereOffset<S>& offset, std::size_t normal_dimension,
                                                   const S& squared_radius, const S& squared_tolerance) {
  const Verdict small = less(offset.squared_radius, squared_radius);
  if (is_refuted(small)) return small;
  if (normal_dimension == 0) return conjunction(small, is_diametric_sphere_within(offset, squared_tolerance));

  const S power = offset.squared_centre_distance() - offset.squared_radius;
  const S tolerance_term = squared_tolerance * squared_radius;
  const S height_term = offset.squared_height * (squared_radius - offset.squared_radius);
  const Verdict from_outside = is_less_than_twice_roots(S(power - squared_tolerance), tolerance_term, height_term);
  const Verdict from_inside =
      disjunction(less(squared_radius, squared_tolerance),
                  is_less_than_twice_roots(S(squared_tolerance - power), tolerance_term, height_term));
  const Verdict on_all_spheres = conjunction(is_zero(offset.squared_height), is_zero(power));
  return conjunction(small, disjunction(on_all_spheres, conjunction(from_outside, from_inside)));
}

}  // namespace delcert
