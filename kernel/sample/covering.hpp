#pragma once

#include <span>
#include <vector>

#include "kernel/stars/proposal.hpp"

namespace delcert {

/// Oriented simplices on the points of a net that cover the torus (the ball), and a bound of the balls they fit in:
/// the witness of density of docs/levels/0-input.md.
template <int m>
struct Covering {
  /// The order of the vertices is the orientation; otherwise in increasing order of labels.
  std::vector<LiftedSimplex<m>> simplices;
  /// Each simplex has its vertices in a closed ball of this radius; where points have units, of this times the least of
  /// them that a vertex has.
  Rational radius_upper;
  /// The centre of the largest of these balls; on a ball, of those with their centre in it (the origin if there is
  /// none).
  Vector<double, m> farthest_centre{};
};

/// Orients the proposed simplices by `proposal_points`, the points they were proposed for, leaves out those that do not
/// meet the ball, bounds their balls, and certifies that they cover: that they form a cycle of degree one (on a ball:
/// relative to what lies outside it). Throws Rejection saying which of this fails and where. `units`: of the points, in
/// (0, 1], of at most 26 binary digits; empty: all are 1.
template <int m>
[[nodiscard]] Covering<m> certified_covering(const FlatSpace<m>& space, const PointSet<m>& net,
                                             const std::vector<Vector<double, m>>& proposal_points,
                                             const std::vector<LiftedSimplex<m>>& proposed,
                                             std::span<const double> units = {});

/// The covering that a triangulation of a copy of the net gives, displaced by less than 2⁻³¹, so that cospherical
/// points are triangulated the same way wherever they are seen; or that `known` gives, a triangulation of the net
/// itself, if there is one and it covers. `usual`: about the distance of neighbours. Throws what `certified_covering`
/// and `propose_delaunay` throw.
template <int m>
[[nodiscard]] Covering<m> cover_net(const FlatSpace<m>& space, const PointSet<m>& net, double usual,
                                    std::span<const double> units = {},
                                    const std::vector<LiftedSimplex<m>>& known = {});

}  // namespace delcert
