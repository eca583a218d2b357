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

/// Lengths are in units of ε. Charts of flat tori are isometric, so one is enough; on space forms it is the charts of
/// the vertices of the simplex in which it is measured.
struct SimplexBounds {
  /// The distance from the circumcentre to the nearest other point, less the circumradius: the least in the charts.
  MeasureEnclosures protection;
  MeasureEnclosures thickness;     ///< the least in the charts
  MeasureEnclosures circumradius;  ///< the greatest in the charts
};

/// Bounds of each simplex, by intervals of doubles that are rounded outwards, from the exact points of the certificate
/// and its rows of labels and group elements. They hold whatever else the certificate claims, with one exception: on
/// flat tori the lower bound of the protection rests on level 4 (`torus_bounds`). Where an interval cannot tell a
/// simplex from a degenerate one, nothing is known: −∞ or 0, and ∞.
///
/// Throws InputError for families other than flat tori and space forms, where ε varies, and where the certificate is
/// not as its format says; Rejection where the group of a space form is not as the certificate says, or patches are too
/// large for it.
[[nodiscard]] SimplexBounds simplex_bounds(const CertificateSummary& certificate);

}  // namespace delcert
