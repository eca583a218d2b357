#pragma once

#include <vector>

#include "kernel/stars/proposal.hpp"

namespace delcert {

/// Oriented simplices on the points of a net that cover the torus (the ball), and a bound of the balls they fit in:
/// the witness of density of docs/levels/0-input.md.
template <int m>
struct Covering {
  /// The order of the vertices is the orientation; otherwise in increasing order of labels.
  std::vector<LiftedSimplex<m>> simplices;
  /// Each simplex has its vertices in a closed ball of this radius.
  Rational radius_upper;
  /// The centre of the largest of these balls; on a ball, of those with their centre in it (the origin if there is
  /// none).
  Vector<double, m> farthest_centre{};
};

/// Orients the proposed simplices by `proposal_points`, the points they were proposed for, leaves out those that do not
/// meet the ball, bounds their balls, and certifies that they cover: that they form a cycle of degree one (on a ball:
/// relative to what lies outside it). Throws Rejection saying which of this fails and where.
template <int m>
[[nodiscard]] Covering<m> certified_covering(const FlatSpace<m>& space, const PointSet<m>& net,
                                             const std::vector<Vector<double, m>>& proposal_points,
                                             const std::vector<LiftedSimplex<m>>& proposed);

}  // namespace delcert
