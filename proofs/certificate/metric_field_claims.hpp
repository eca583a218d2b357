#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/manifold/gluing/chart_distortion.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "kernel/theorems/affine_triangulation.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/delaunay_margin.hpp"

namespace delcert {

/// What a certificate claims at level 4 of a metric field.
struct MetricFieldDelaunayClaim {
  Rational edge;    ///< a lower bound of the longest edge of every simplex
  Rational margin;  ///< of stability, in squares of lengths
};

/// The levels that a run on a metric field reaches, with their margins: lengths in the charts, not in units of ε.
struct MetricFieldClaims {
  std::optional<StarMargins> stars;                  ///< level 1
  std::optional<ManifoldClaim> manifold;             ///< level 2
  std::optional<Rational> reach;                     ///< level 2s: how far charts have to show
  std::optional<MetricFieldDelaunayClaim> delaunay;  ///< level 4
  bool triangulation = false;                        ///< level 5
  /// For level 4, wherever it was asked for and levels 1, 2 and 5 hold.
  std::optional<DelaunayMargin> stability;

  /// The names of the levels claimed, in order.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// Patches, and how much longer a vector may be there than at home: what certification asks of a metric field.
template <int m>
[[nodiscard]] ModelGeometry geometry_of(const MetricFieldAtlas<m>& atlas, const ChartDistortion& distortion) {
  ModelGeometry geometry;
  geometry.patch_factor = atlas.patch_factor();
  geometry.distortion = relative_stretch(distortion);
  return geometry;
}

/// What is measured of a certified run beyond levels 1 and 2.
struct MetricFieldMeasures {
  StarStability stability;                  ///< level 2s
  AffineTriangulationReport triangulation;  ///< levels 4 and 5
};

/// Derives the levels from a certified run and its measures, checking the inequalities of docs/certificate-format.md
/// on the way; reasons for levels that were selected and are not reached are appended to `reasons`. Bounds are weaker
/// than what was found by a relative 2⁻²⁰ at least.
template <int m>
[[nodiscard]] MetricFieldClaims derive_claims(const MetricFieldAtlas<m>& atlas, const RunParameters& parameters,
                                              const ChartDistortion& distortion, const ChartRun<m>& run,
                                              const MetricFieldMeasures& measures, const LevelSelection& selection,
                                              std::vector<std::string>& reasons);

}  // namespace delcert
