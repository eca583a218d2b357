#pragma once

#include <string>
#include <vector>

#include "kernel/theorems/graph_triangulation.hpp"

namespace delcert {

/// Which distance on M: that of the space around, or the length of curves in M.
enum class GraphMetric : unsigned char { extrinsic, intrinsic };

/// Level 4 of a submanifold (docs/levels/submanifolds.md): whether a complex that triangulates M is the Delaunay
/// complex of its vertices in M, for one distance.
struct RestrictedDelaunay {
  std::vector<Label> failures;  ///< whose discs are not certainly covered (4.patch, 4.cover)
  std::vector<Label> unclear;   ///< 4.clear: the least labels of components without a clear label
  std::size_t boxes = 0;        ///< looked at

  [[nodiscard]] bool holds() const { return failures.empty() && unclear.empty(); }
};

/// How far points of M are from a nearest vertex, along M (4.density), with a margin.
struct GraphDensity {
  std::vector<double> reaches;  ///< r̂_i, for points to which label i is nearest
  Rational density;             ///< r̂: r̂_i is at most this times the unit of i; few binary digits
};

/// Precondition: the complex triangulates M.
template <int m>
[[nodiscard]] GraphDensity graph_density(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
                                         const GraphTriangulation<m>& triangulation, const Rational& slope);

/// Rules 4.patch, 4.cover and 4.clear, in parallel; the discs of all labels are divided into boxes until each of them
/// is seen to be nearer to another label, or to be a place where only the vertices of one simplex may be nearest.
/// The reaches are the radii of the discs.
/// Preconditions: the complex triangulates M, its vertices are on M; rounding to nearest.
template <int m>
[[nodiscard]] RestrictedDelaunay check_restricted_delaunay(const GraphVertices& vertices,
                                                           const std::vector<LabelSimplex<m>>& simplices,
                                                           const GraphTriangulation<m>& triangulation,
                                                           const Rational& slope, const GraphDensity& density,
                                                           GraphMetric metric, const Progress& progress);

}  // namespace delcert
