#pragma once

#include <vector>

#include "kernel/manifold/submanifold/zero_set.hpp"
#include "kernel/theorems/graph_simplex.hpp"
#include "support/progress.hpp"

namespace delcert {

/// Lower bound of the reach of a submanifold: the greatest number such that every point nearer to M has one nearest
/// point on M.
struct ReachBound {
  double curvature = 0;   ///< κ: the second fundamental form of M has at most this norm
  double bottleneck = 0;  ///< no segment shorter than this is normal to M at both of its ends
  /// min{1/κ, bottleneck/2}: E. Aamari, J. Kim, F. Chazal, B. Michel, A. Rinaldo, L. Wasserman, Estimating the reach of
  /// a manifold, Electron. J. Stat. 13 (2019), Theorem 3.4. 0 where nothing could be shown.
  double reach = 0;
};

/// In parallel. The vertices are on the zero set. `density`: a length for each label i, with which every point of M is
/// within density[i] of some p′_i, along M. Segments are looked at up to the length `greatest_length` only, about;
/// `slope` is L. Preconditions: M is a zero set; the simplices, with vertices on M, triangulate M
/// (`GraphTriangulation`); the equations have continuous second derivatives; rounding to nearest.
template <int m>
[[nodiscard]] ReachBound bound_reach(const ZeroSet& zero_set, const GraphVertices& vertices,
                                     const std::vector<LabelSimplex<m>>& simplices, const std::vector<double>& density,
                                     const Rational& slope, double greatest_length, const Progress& progress);

}  // namespace delcert
