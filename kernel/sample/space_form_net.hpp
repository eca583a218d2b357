#pragma once

#include <cstdint>

#include "kernel/sample/space_form_points.hpp"
#include "support/progress.hpp"

namespace delcert {

/// A maximal Poisson-disk set of X/Γ: pairwise distances at least `radius`, and every point of the manifold closer than
/// radius·(1 + 2⁻²⁷) to one of them. Dart throwing, then a random point near every vertex of a Voronoi cell that is
/// farther than the radius from its point, chart by chart, until there is none. The same for a seed everywhere.
///
/// Made in doubles: what comes out is to be measured, not believed. Throws Rejection when the radius does not fit the
/// manifold (it is more than a third of the injectivity radius), or there would be more than 16 000 000 points.
template <int m>
[[nodiscard]] SpaceFormNet<m> space_form_net(const SpaceForm& form, const Rational& radius, std::uint64_t seed,
                                             const Progress& progress);

/// The net with these points, each by the lift nearest to o and rounded, and how dense it is. `radius`: about the
/// covering radius, which is seen up to 1.12 times that. Throws as `space_form_net`.
template <int m>
[[nodiscard]] SpaceFormNet<m> measured_net(const SpaceForm& form, const std::vector<Vector<Rational, m>>& centres,
                                           const Rational& radius);

/// The net after some of Lloyd's steps: every point moves to the mass centre of its Voronoi cell, all at once, each in
/// the chart of the point before. Simplices become better; distances are no longer at least anything. Throws as
/// `space_form_net`.
template <int m>
[[nodiscard]] SpaceFormNet<m> relaxed_net(const SpaceForm& form, const std::vector<Vector<Rational, m>>& centres,
                                          const Rational& radius, std::uint32_t steps, const Progress& progress);

}  // namespace delcert
