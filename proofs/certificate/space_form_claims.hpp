#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kernel/run/chart_run.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "kernel/theorems/piecewise_flat.hpp"
#include "kernel/theorems/riemannian_simplices.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/run_parameters.hpp"

namespace delcert {

/// What is measured of a certified run on a space form beyond levels 1, 2 and 4.
struct SpaceFormMeasures {
  StarStability stability;        ///< level 2s
  RiemannianSimplices simplices;  ///< level 5, by the theorem of Dyer, Vegter and Wintraecken
  PiecewiseFlatReport flat;       ///< level 6
};

/// Precondition: the run is certified. Needs rounding to nearest.
template <int m>
[[nodiscard]] SpaceFormMeasures measure_run(const SpaceFormAtlas<m>& atlas, const ChartRun<m>& run,
                                            const Progress& progress);

/// Derives the levels from a certified run and its measures, checking the inequalities of docs/certificate-format.md
/// on the way; reasons for levels that are not reached are appended to `reasons`.
template <int m>
[[nodiscard]] Claims derive_claims(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters,
                                   const ChartRun<m>& run, const SpaceFormMeasures& measures,
                                   const LevelSelection& selection, std::vector<std::string>& reasons);

/// The same from what is known of the whole where no process has its complex. `manifold` is asked for level 2.
template <int m>
[[nodiscard]] Claims derive_claims(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters,
                                   const LocalMargins& margins, const std::function<ManifoldClaim()>& manifold,
                                   const ModelReport& model, const SpaceFormMeasures& measures,
                                   const LevelSelection& selection, std::vector<std::string>& reasons);

}  // namespace delcert
