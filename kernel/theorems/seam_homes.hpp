#pragma once

#include <optional>
#include <vector>

#include "kernel/manifold/gluing/formula_atlas.hpp"
#include "kernel/stars/chart_complex.hpp"
#include "support/progress.hpp"

namespace delcert {

/// A net on which some labels have other home charts, and points that are where they were, but for roundings. The
/// centre of a label with another home is its point there, which is not moved from it.
template <int m>
struct SeamHomes {
  std::vector<NetPlace<m>> net;
  PointSet<m> points;
  int rounds = 0;           ///< how often homes were chosen
  std::size_t changed = 0;  ///< labels with another home
};

/// Homes such that no simplex between charts is thought to be folded by its blend (level 5 of docs/levels/atlases.md):
/// the labels of simplices that may be get one home, round by round, until there are no others, or as many rounds as
/// are allowed. None if that does not end, if a chart does not show what it has to, or if nothing fails.
///
/// A heuristic: whether stars are the same in the charts of the other homes is for the caller to certify. `simplices`
/// as for `check_blended_triangulation`. Precondition: rounding to nearest.
template <int m>
[[nodiscard]] std::optional<SeamHomes<m>> homes_without_folds(std::shared_ptr<const ChartGluing> gluing,
                                                              const FormulaAtlas<m>& atlas, const PointSet<m>& points,
                                                              const std::vector<LabelSimplex<m>>& simplices,
                                                              int most_rounds, const Progress& progress);

}  // namespace delcert
