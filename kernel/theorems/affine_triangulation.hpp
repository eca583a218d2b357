#pragma once

#include "kernel/manifold/gluing/metric_field_atlas.hpp"
#include "kernel/stars/chart_complex.hpp"

namespace delcert {

/// Level 5 where charts are affine images of the coordinates of a torus (docs/metric-fields.md).
struct AffineTriangulationReport {
  /// 5.lifts: simplices of stars whose vertices another star of theirs shows at other lifts, or not at all.
  std::size_t other_lifts = 0;
  std::size_t listed = 0;  ///< simplices of stars that were compared with the stars of their other labels
  /// 5.volume: an enclosure of Σ |det| over all m-simplices, over m!: the number of sheets.
  double least_sheets = 0;
  double most_sheets = 0;
  /// 4.edge: in the chart of each star every simplex of it has an edge of at least this length.
  double edge = 0;

  /// Whether straight simplices triangulate the torus, given that levels 1 and 2 hold.
  [[nodiscard]] bool holds() const { return listed > 0 && other_lifts == 0 && most_sheets < 2; }
};

/// Compares lifts, measures edges, and adds up volumes, each simplex at its smallest label. Precondition: the stars of
/// the complex are certified and agree; rounding to nearest.
template <int m>
[[nodiscard]] AffineTriangulationReport check_affine_triangulation(const MetricFieldAtlas<m>& atlas,
                                                                   const PointSet<m>& points,
                                                                   const ChartComplex<m>& complex);

}  // namespace delcert
