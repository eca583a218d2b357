#pragma once

#include <vector>

#include "kernel/manifold/submanifold/submanifold_atlas.hpp"
#include "kernel/theorems/graph_simplex.hpp"
#include "support/progress.hpp"

namespace delcert {

template <int m>
struct GraphSimplexFailure {
  LabelSimplex<m> simplex;
  GraphCause cause;
};

/// Level 5 of a submanifold (docs/levels/submanifolds.md): whether the straight simplices, moved along fibres,
/// triangulate M.
template <int m>
struct GraphTriangulation {
  std::vector<GraphSimplexFailure<m>> failures;  ///< of 5.fibre and 5.contract, in the order of the simplices
  std::vector<Label>
      unclear;  ///< 5.clear: the least labels of components of which no label is certainly alone above its place
  /// ω: no point of a simplex is moved by more, times the least unit of its vertices; few binary digits, with a margin.
  Rational displacement{};
  Rational contraction{};  ///< γ < 1: how far the map is from the identity in charts; few binary digits, with a margin
  std::vector<GraphSimplex<m>> simplices;  ///< what was measured of each
  std::vector<std::uint32_t> component;    ///< of each label: the least label of its component

  [[nodiscard]] bool triangulates() const { return failures.empty() && unclear.empty(); }
};

/// Where these points of the atlas are. Throws Undecided, with the label, if one cannot be enclosed. Precondition:
/// rounding to nearest.
template <int m>
[[nodiscard]] GraphVertices graph_vertices(const SubmanifoldAtlas<m>& atlas, const PointSet<m>& points);

/// The centres of the charts, exactly, as points that are on M or near it. Throws Undecided, with the label, where the
/// equations are not certainly defined. Precondition: rounding to nearest.
[[nodiscard]] GraphVertices given_vertices(const ZeroSet& zero_set, const std::vector<TangentChart>& charts);

/// In parallel. `simplices`: all m-simplices, each once, of a complex of which level 2 holds. Precondition: rounding to
/// nearest.
template <int m>
[[nodiscard]] GraphTriangulation<m> check_graph_triangulation(const GraphVertices& vertices,
                                                              const std::vector<LabelSimplex<m>>& simplices,
                                                              const Progress& progress);

}  // namespace delcert
