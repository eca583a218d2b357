#pragma once

#include <string>
#include <vector>

#include "kernel/manifold/gluing/chart_distortion.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "kernel/theorems/affine_triangulation.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/run_parameters.hpp"

namespace delcert {

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
/// on the way; reasons for levels that were selected and are not reached are appended to `reasons`.
template <int m>
[[nodiscard]] Claims derive_claims(const MetricFieldAtlas<m>& atlas, const RunParameters& parameters,
                                   const ChartDistortion& distortion, const ChartRun<m>& run,
                                   const MetricFieldMeasures& measures, const LevelSelection& selection,
                                   std::vector<std::string>& reasons);

}  // namespace delcert
