#pragma once

#include <limits>

#include "kernel/chart/label_range.hpp"
#include "kernel/stars/chart_complex.hpp"
#include "support/progress.hpp"

namespace delcert {

/// The hypotheses of the theorem of Dyer, Vegter and Wintraecken that the paper quotes (thm:riem.del.tri; rules
/// 5.thickness and 5.radius of docs/levels/space-forms.md), measured.
struct RiemannianSimplices {
  double thickness = 0;  ///< t₀: every simplex of star(i) is at least this thick in the chart exp⁻¹ at p′_i itself
  double star_radius = 0;  ///< no vertex of star(i) is farther than this from p′_i
  double scale = 0;        ///< no more than min{inj/4, t₀/(6√Λ)}, Λ = |K|
  /// Whether the star radius is at most the scale and t₀ > 0; undecided if a star could not be measured.
  Verdict holds = Verdict::undecided;
};

/// What is measured of some stars.
struct StarsAboutPoints {
  double thickness = std::numeric_limits<double>::infinity();
  double star_radius = 0;
  bool is_complete = true;

  /// Takes over what was measured of others.
  void include(const StarsAboutPoints& other);
};

/// Measures the stars of all interior labels in the charts at the perturbed points. That stars are full there is what
/// levels 1 and 4 say of them. Precondition: rounding to nearest.
template <int m>
[[nodiscard]] RiemannianSimplices measure_riemannian_simplices(const Atlas<m>& atlas, const PointSet<m>& points,
                                                               const ModelGeometry& geometry,
                                                               const ChartComplex<m>& complex,
                                                               const Progress& progress);

/// The same of the stars of some labels, and what follows when all are included.
template <int m>
[[nodiscard]] StarsAboutPoints measure_stars_about_points(const Atlas<m>& atlas, const PointSet<m>& points,
                                                          const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                                          LabelRange labels, const Progress& progress);
[[nodiscard]] RiemannianSimplices riemannian_simplices(const StarsAboutPoints& all, const ModelGeometry& geometry);

}  // namespace delcert
