#pragma once

#include <cstdint>
#include <vector>

#include "kernel/sample/torus_sizing.hpp"
#include "kernel/stars/proposal.hpp"
#include "support/progress.hpp"

namespace delcert {

/// A maximal Poisson-disk set: pairwise distances at least `radius`, and every point of the torus (of the ball) closer
/// than `radius` to one of them. Dart throwing, then a random point in every Delaunay simplex whose circumradius
/// exceeds the radius, until there is none. Dyadic coordinates; labels in the order of a space-filling curve.
///
/// A finite net of a ball of radius r is sampled in the ball of radius r + 2·radius about the same centre, so that
/// the whole of its domain is covered by simplices.
///
/// Made in doubles: what comes out is measured (`measure_net`), not believed. Throws Rejection when the radius does
/// not fit the space.
template <int m>
[[nodiscard]] std::vector<Vector<Rational, m>> poisson_disk_net(const FlatSpace<m>& space, const Rational& radius,
                                                                std::uint64_t seed, const Progress& progress);

/// A net, and the Delaunay triangulation in which no gap was left, of labels, as `propose_delaunay` has it.
template <int m>
struct TriangulatedNet {
  std::vector<Vector<Rational, m>> points;
  std::vector<LiftedSimplex<m>> simplices;
};

/// The same net with this triangulation.
template <int m>
[[nodiscard]] TriangulatedNet<m> triangulated_poisson_disk_net(const FlatSpace<m>& space, const Rational& radius,
                                                               std::uint64_t seed, const Progress& progress);

/// The same with radii that vary: of two points at least one is no nearer to the other than e there, and no simplex of
/// the Delaunay triangulation has a circumradius above the least e of its vertices; both nearly, where e varies.
template <int m>
[[nodiscard]] std::vector<Vector<Rational, m>> poisson_disk_net(const FlatSpace<m>& space, const TorusSizing<m>& sizing,
                                                                std::uint64_t seed, const Progress& progress);

}  // namespace delcert
