#pragma once

#include "proofs/drawing/simplex_bounds.hpp"

namespace delcert {

/// `simplex_bounds` of a flat torus.
///
/// It is enough to look at the neighbours of the vertices: let c be the circumcentre of a simplex and p the nearest
/// point that is not a vertex of it. The balls through p with centres on the segment from p to c lie in the ball around
/// c through p, in whose interior are only vertices of the simplex. The smallest of them that reaches another point
/// than p reaches a vertex, and is empty inside: so p and this vertex are on an edge of the Delaunay complex. Hence the
/// lower bounds of the protection hold if the complex is that one, which is level 4.
[[nodiscard]] SimplexBounds torus_bounds(const CertificateSummary& certificate);

}  // namespace delcert
