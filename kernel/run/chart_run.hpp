#pragma once

#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "kernel/run/run.hpp"
#include "kernel/stars/chart_complex.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "kernel/theorems/model_delaunay.hpp"

namespace delcert {

/// The outcome of the extended algorithm on a space form.
template <int m>
struct ChartRun {
  PointSet<m> points;
  ChartComplex<m> complex;
  LocalMargins margins;     ///< of the certified stars, each in its own chart: lengths, as multiples of `LengthUnits`
  StarAgreement agreement;  ///< of the stars
  ModelReport model;        ///< of level 4; nothing is asked of it before the stars are certified and agree
  std::vector<StarFailure> star_failures;
  StarAgreement first_agreement;   ///< before anything was repaired
  std::size_t first_failures = 0;  ///< stars that were not certified then
  PerturbationStatistics statistics;
  int repair_rounds = 0;
  std::size_t repaired_points = 0;
  std::optional<StarStability> stability;  ///< if it was asked for, and the stars are certified and agree

  /// Whether levels 1, 2 and 4 are certified.
  [[nodiscard]] bool is_certified() const {
    return star_failures.empty() && agreement.failures.empty() && model.failures.empty();
  }
};

/// Perturbs, computes all stars, each in its own chart, and certifies them; compares them; certifies the geodesic
/// circumballs, or looks at all stars in all charts, if that is asked for. Places the points of what fails anew, round
/// by round, until nothing fails or the rounds are used up; only stars that a moved point may concern are computed
/// again. Without perturbation nothing is repaired.
///
/// The result depends on the atlas, the geometry, the parameters and the request only. Precondition: rounding to
/// nearest.
template <int m>
[[nodiscard]] ChartRun<m> run_in_charts(const Atlas<m>& atlas, const ModelGeometry& geometry,
                                        const PerturbationParameters& parameters, const RunRequest& request,
                                        const Progress& progress);

/// What such a run finds of these points as they are: stars, and whether they agree. Nothing is repaired, and nothing
/// is asked of level 4.
template <int m>
[[nodiscard]] ChartRun<m> stars_in_charts(const Atlas<m>& atlas, const ModelGeometry& geometry, PointSet<m> points,
                                          const RunRequest& request, const Progress& progress);

/// Curvature and certified injectivity radius of a verified group, and the size of the patches.
template <int m>
[[nodiscard]] ModelGeometry geometry_of(const SpaceFormAtlas<m>& atlas);

/// The same with these.
template <int m>
[[nodiscard]] ChartRun<m> run_in_charts(const SpaceFormAtlas<m>& atlas, const PerturbationParameters& parameters,
                                        const RunRequest& request, const Progress& progress) {
  return run_in_charts<m>(atlas, geometry_of(atlas), parameters, request, progress);
}

/// The parameters of a run that claims nothing beforehand (docs/space-forms.md): tolerances that a net of any space
/// form stands, for curves and surfaces and in dimension 3. Throws std::invalid_argument for another dimension.
[[nodiscard]] PerturbationParameters measured_parameters(Dimension dimension, std::uint64_t seed);

}  // namespace delcert
