#pragma once

#include "proofs/drawing/simplex_bounds.hpp"

namespace delcert {

/// `simplex_bounds` of a space form of dimension 2 or 3, in the charts of the vertices of each simplex, of all points
/// that these show.
[[nodiscard]] SimplexBounds space_form_bounds(const CertificateSummary& certificate);

}  // namespace delcert
