#pragma once

#include "kernel/chart/label_range.hpp"
#include "kernel/stars/chart_complex.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What one chart says of the stars that it has to show: that of its label, and those of the labels in it.
struct ChartStability {
  std::size_t pairs = 0;                ///< stars looked at
  std::vector<StarFailure> failures;    ///< one for each star that is not certified to be the same, in order
  std::optional<LocalMargins> margins;  ///< of the simplices that are certified, in this chart; none if there are none
};

/// Level 2s: whether the star of every label is the same in the charts of all its vertices.
struct StarStability {
  std::size_t pairs = 0;      ///< stars times charts looked at
  std::size_t differing = 0;  ///< pairs in which the star is not certified to be the same
  std::size_t stars = 0;      ///< labels in such a pair
  std::size_t occupied = 0;   ///< of these, labels with a pair in which another point is shown to be in a closed ball
  std::vector<StarFailure> failures;  ///< one for each such pair: which star, in which chart, why
  LocalMargins margins;  ///< of all simplices in all these charts, where nothing fails: as multiples of units
};

/// Checks star(i), as it is in the chart of i, in the chart of another label j, for all labels i of star(j): with the
/// points that chart j shows, every simplex has an empty circumball with a margin in the patch. As the faces at i are
/// in exactly two simplices each, these are then the simplices of the star in chart j too
/// (docs/levels/space-forms.md). Each simplex is looked at once, with no more of the patch than its ball needs.
///
/// The result depends on atlas, points, complex and label only; `scratch` is a view of these. Preconditions: `chart`
/// is interior; rounding to nearest.
template <int m>
[[nodiscard]] ChartStability stability_in_chart(ChartView<m>& scratch, const ChartComplex<m>& complex, Label chart);

/// The same for all interior labels j. Where charts are isometric and stars agree, each simplex is looked at in one
/// chart only, if that decides all. Precondition: rounding to nearest.
template <int m>
[[nodiscard]] StarStability check_stability(const Atlas<m>& atlas, const PointSet<m>& points,
                                            const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                            const Progress& progress);

/// What some charts say.
struct StabilityInCharts {
  std::size_t pairs = 0;
  std::vector<StarFailure> failures;    ///< one for each pair that differs
  std::optional<LocalMargins> margins;  ///< as multiples of units; none if there are none
};

/// The same as `check_stability` in the charts of some labels only, which need not be isometric: the stars of what they
/// see are in the complex.
template <int m>
[[nodiscard]] StabilityInCharts check_stability_in(const Atlas<m>& atlas, const PointSet<m>& points,
                                                   const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                                   LabelRange charts, const Progress& progress);
/// Of all charts.
[[nodiscard]] StarStability star_stability(StabilityInCharts all);

}  // namespace delcert
