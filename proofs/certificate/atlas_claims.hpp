#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/manifold/gluing/atlas_distortion.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "kernel/theorems/blended_triangulation.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/run_parameters.hpp"

namespace delcert {

/// What is measured of a certified run on an atlas by formulas beyond levels 1 and 2.
template <int m>
struct AtlasMeasures {
  StarStability stability;                               ///< level 2s
  std::optional<BlendedTriangulation<m>> triangulation;  ///< level 5, if it is asked for
};
template <int m>
[[nodiscard]] AtlasMeasures<m> measure_atlas(const FormulaAtlas<m>& atlas, const ChartRun<m>& run,
                                             const ModelGeometry& geometry, const LevelSelection& selection,
                                             const Progress& progress);

/// Derives the levels from a certified run and its measures, checking the inequalities of docs/certificate-format.md
/// on the way; reasons for levels that were selected and are not reached are appended to `reasons`.
template <int m>
[[nodiscard]] Claims derive_claims(const FormulaAtlas<m>& atlas, const RunParameters& parameters,
                                   const ChartRun<m>& run, const AtlasMeasures<m>& measures,
                                   const LevelSelection& selection, std::vector<std::string>& reasons);

}  // namespace delcert
