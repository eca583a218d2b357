#pragma once

#include <cstdint>
#include <vector>

#include "kernel/manifold/space_form/space_form.hpp"
#include "kernel/progress.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

template <int m>
struct SpaceFormNet {
  /// Conformal coordinates of one lift of each point, the one nearest to o (for curvature 0: coordinates of the frame).
  /// Multiples of 2⁻⁴⁸, and doubles. In the order of a space-filling curve.
  std::vector<Vector<Rational, m>> centres;
  /// In doubles, without error bounds: the greatest distance of a point of M from the net, the least in it.
  double covering_radius = 0;
  double separation = 0;
};

/// A maximal Poisson-disk set of X/Γ: pairwise distances at least `radius`, and every point of the manifold closer than
/// radius·(1 + 2⁻²⁷) to one of them. Dart throwing, then a random point near every vertex of a Voronoi cell that is
/// farther than the radius from its point, chart by chart, until there is none. The same for a seed everywhere.
///
/// Made in doubles: what comes out is to be measured, not believed. Throws Rejection when the radius does not fit the
/// manifold (it is more than a third of the injectivity radius), or there would be more than 4 000 000 points.
template <int m>
[[nodiscard]] SpaceFormNet<m> space_form_net(const SpaceForm& form, const Rational& radius, std::uint64_t seed,
                                             const Progress& progress);

}  // namespace delcert
