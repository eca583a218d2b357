#pragma once

#include <vector>

#include "kernel/theorems/graph_simplex.hpp"
#include "support/progress.hpp"

namespace delcert {

/// How far the simplices are from meeting while they move along fibres to M: rules 5i.star and 5i.apart of
/// docs/levels/submanifolds.md.
struct SimplexPairs {
  double margin = 0;           ///< in units, a lower bound; the rules hold if it is above 0
  Label tightest{0};           ///< a label of a pair of which it is that
  std::vector<Label> crowded;  ///< in increasing order, the tight labels of pairs of which it is not above 0
};

/// Looks at all pairs of simplices that have a tight label each, in parallel. The margin is `most` if it is more.
/// Preconditions: `measures` says of each simplex that the rules of level 5 hold with this displacement and is of this
/// order; rounding to nearest; `most` > 0.
template <int m>
[[nodiscard]] SimplexPairs check_simplex_pairs(const GraphVertices& vertices,
                                               const std::vector<LabelSimplex<m>>& simplices,
                                               const std::vector<GraphSimplex<m>>& measures,
                                               const std::vector<bool>& is_tight, double displacement, double most,
                                               const Progress& progress);

}  // namespace delcert
