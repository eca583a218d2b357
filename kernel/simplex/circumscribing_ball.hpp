#pragma once

#include <cstddef>

#include "kernel/simplex/sphere_distance.hpp"

namespace delcert {

/// Whether σ ⊂ ℝᵐ has *some* circumscribing ball B(C, R) with R < radius and ||p − C| − R| ≤ tolerance, for the point p
/// with the given offset against σ. `normal_dimension` is the dimension m − dim aff σ of the space of centres.
///
/// With h the height of p, w = |p − C(σ)|² − R(σ)², e = radius, t = tolerance and T² = e² − R(σ)²: there is one iff
///   R(σ) < e  and  [ h = 0 and w = 0,  or  w − t² < 2et + 2hT and (t > e or t² − w < 2et + 2hT) ]
/// (proof in docs/simplices.md), except that in normal dimension 0 only the smallest circumscribing ball is left.
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
