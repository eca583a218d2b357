#pragma once

#include "kernel/chart/label_range.hpp"
#include "kernel/stars/chart_complex.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What is certified of the geodesic circumballs of the simplices of a complex on a space form X/Γ, or why not.
struct ModelReport {
  /// Lengths in X, if there are no failures.
  double protection = 0;    ///< every other lift is farther from the centre than the radius plus this
  double circumradius = 0;  ///< no circumball has a larger radius
  std::vector<StarFailure> failures;

  /// Takes over what was found of other simplices.
  void include(ModelReport other);
  /// Fails unless four times the largest circumradius is less than twice the injectivity radius.
  void check_lifts(const ModelGeometry& geometry);
};

/// The rules 4.ball and 4.empty with what Theorem C4 follows from (docs/levels/core.md), each simplex at its smallest
/// interior label with the lifts that the chart of that label shows: the circumball exists (on the sphere with a radius
/// below a right angle), every other lift is strictly outside of it, and four times the largest radius is less than
/// twice the injectivity radius. Decided in conformal coordinates about the centre of the chart, in which the balls of
/// X are the balls that do not reach the boundary of the model. With the stars certified in their charts and in
/// agreement the complex is the Delaunay complex of M.
/// Precondition: rounding to nearest.
template <int m>
[[nodiscard]] ModelReport check_model_delaunay(const Atlas<m>& atlas, const PointSet<m>& points,
                                               const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                               const Progress& progress);

/// What that finds of the simplices at some labels, for several processes to `include` in one; then come the lifts.
template <int m>
[[nodiscard]] ModelReport check_circumballs(const Atlas<m>& atlas, const PointSet<m>& points,
                                            const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                            LabelRange labels, const Progress& progress);

}  // namespace delcert
