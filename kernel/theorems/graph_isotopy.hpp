#pragma once

#include <optional>
#include <vector>

#include "kernel/theorems/graph_triangulation.hpp"
#include "support/progress.hpp"

namespace delcert {

/// Level 5i of a submanifold (docs/levels/submanifolds.md): whether the straight simplices are embedded in ℝᴺ, and
/// their union is ambient isotopic to M.
struct GraphIsotopy {
  /// By room around labels and between simplices: in units, a lower bound; the rules hold if it is above 0.
  double margin = 0;
  Label tightest{0};           ///< where it is least
  std::vector<Label> crowded;  ///< labels at which these rules fail
  /// By normals, if rule 5i.normal holds where the others fail: a lower bound of the cosines of the angles between the
  /// normal of a simplex and the gradients along it, above 0.
  std::optional<double> cosine;

  [[nodiscard]] bool holds() const { return margin > 0 || cosine; }
};

/// In parallel. Preconditions: level 5 holds, as `triangulation` says of these simplices; rounding to nearest.
template <int m>
[[nodiscard]] GraphIsotopy check_graph_isotopy(const GraphVertices& vertices,
                                               const std::vector<LabelSimplex<m>>& simplices,
                                               const GraphTriangulation<m>& triangulation, const Progress& progress);

}  // namespace delcert
