#pragma once

#include <string>
#include <vector>

#include "kernel/chart/length_units.hpp"
#include "kernel/stars/local_ball.hpp"
#include "kernel/stars/star_complex.hpp"

namespace delcert {

/// The vertices of a simplex of a star but the one whose star it is, by label, as its chart sees them.
template <int m>
using ChartSimplex = std::array<Sighting<m>, static_cast<std::size_t>(m)>;

/// star(i) in the chart of i, simplices sorted.
template <int m>
struct ChartStar {
  Label label;
  std::vector<ChartSimplex<m>> simplices;
};

/// Bounds that hold for every simplex at hand; lengths, not multiples of ε. Doubles are exact numbers here.
struct LocalMargins {
  double protection = 0;    ///< every other point is farther from the circumcentre than the circumradius plus this
  double thickness = 0;     ///< every simplex is at least this thick
  double circumradius = 0;  ///< no circumradius is larger
  double reach = 0;         ///< no circumball goes farther than this from the centre of the chart

  /// Lengths as multiples of the unit of this label, not better than they are.
  [[nodiscard]] LocalMargins as_multiples(const LengthUnits& units, Label i) const;
  /// Of the simplices of both.
  void include(const LocalMargins& other);
};

/// A star and what is certified of it in its chart.
template <int m>
struct CertifiedStar {
  ChartStar<m> star;
  LocalMargins margins;               ///< if there are no failures
  std::vector<StarFailure> failures;  ///< empty exactly if the star is certified
  double reach = 0;                   ///< original points within this distance had a say
};

/// The star of p′_i in the Delaunay complex of the points that its chart shows (level 1 of docs/levels/space-forms.md):
/// proposed in doubles, then certified. Certified means: every simplex is non-degenerate, its closed circumball grown
/// by a positive margin holds no other lift of a point and lies where the chart shows all of them, all its labels are
/// different, and every (m−1)-face at i is in exactly two simplices. What is undecided at the last rung is not
/// certified. The protection is not looked for beyond half a sampling radius. A simplex whose protection is not above
/// `required_protection` is a failure too.
///
/// The result depends on atlas, points and label only; `scratch` is a view of these. Precondition: rounding to nearest.
template <int m>
[[nodiscard]] CertifiedStar<m> chart_star(ChartView<m>& scratch, Label i, double required_protection = 0);

/// Why a simplex is not certified.
struct SimplexFailure {
  FailureCause cause = FailureCause::undecided;
  std::string reason;
};

/// What is certified of one simplex of a view in the chart, added to `margins`; or why it is not, with the
/// place of a point that is to blame in `witness` (the size of the view for none). The protection is not looked for
/// beyond a sampling radius divided by `look_beyond_part`.
template <int m>
[[nodiscard]] std::optional<SimplexFailure> chart_simplex_failure(const ChartView<m>& view,
                                                                  const PlaceSimplex<m>& simplex,
                                                                  double required_protection, LocalMargins& margins,
                                                                  std::size_t& witness, int look_beyond_part = 2);

/// "simplex {1, 2, 3}".
[[nodiscard]] std::string simplex_text(std::vector<Label> labels);

}  // namespace delcert
