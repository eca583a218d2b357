#pragma once

#include <vector>

#include "proofs/certificate/reader.hpp"

namespace delcert {

/// Bounds of a measure of each simplex, in the order of the certificate: lower[k] ≤ the measure of simplex k ≤
/// upper[k].
struct MeasureEnclosures {
  std::vector<double> lower;
  std::vector<double> upper;
};

struct SimplexBounds {
  /// The distance from the circumcentre to the nearest other point, less the circumradius, in units of ε.
  MeasureEnclosures protection;
  MeasureEnclosures thickness;
  MeasureEnclosures circumradius;  ///< in units of ε
};

/// Bounds of each simplex of a flat torus, by intervals of doubles that are rounded outwards, from the exact points of
/// the certificate. Thickness, circumradius and the upper bound of the protection hold for these points and rows of
/// labels whatever else the certificate claims. The lower bound of the protection holds if the complex is the Delaunay
/// complex of the points, which is level 4: then it is enough to look at the neighbours of the vertices, as follows.
/// Let c be the circumcentre of a simplex and p the nearest point that is not a vertex of it. The balls through p with
/// centres on the segment from p to c lie in the ball around c through p, in whose interior are only vertices of the
/// simplex. The smallest of them that reaches another point than p reaches a vertex, and is empty inside: so p and this
/// vertex are on an edge of the Delaunay complex. Where an interval cannot tell a simplex from a degenerate one, the
/// bounds are 0 and infinity.
///
/// Throws InputError for other families, where ε varies, and where the certificate is not as its format says.
[[nodiscard]] SimplexBounds simplex_bounds(const CertificateSummary& certificate);

}  // namespace delcert
