#pragma once

#include <vector>

#include "kernel/theorems/blended_simplex.hpp"
#include "support/progress.hpp"

namespace delcert {

template <int m>
struct BlendFailure {
  LabelSimplex<m> simplex;
  BlendCause cause;
};

/// Level 5 of an atlas by formulas (docs/levels/atlases.md): whether simplices, straight in the home charts of their
/// vertices and blended where these are several, triangulate M.
template <int m>
struct BlendedTriangulation {
  std::size_t seams = 0;                  ///< simplices with several home charts
  std::vector<BlendFailure<m>> failures;  ///< of 5.blend, in the order of the simplices
  std::vector<Label> unclear;             ///< 5.clear: the least labels of components without a label that is clear
  std::vector<std::size_t> unseen;        ///< 5.components: charts of the file that show no label
  Rational displacement{};  ///< λ: no point is farther from where one of its home charts has it; few binary digits
  /// γ < 1: blends differ from the identity by a map with this Lipschitz constant, or keep (1 − γ)ᵐ of all volumes; few
  /// binary digits.
  Rational contraction{};

  [[nodiscard]] bool triangulates() const { return failures.empty() && unclear.empty() && unseen.empty(); }
};

/// `simplices`: all m-simplices, each once, of a complex of which levels 1 and 2 hold. Throws
/// Undecided where it is not certain what charts show. Precondition: rounding to nearest.
template <int m>
[[nodiscard]] BlendedTriangulation<m> check_blended_triangulation(const FormulaAtlas<m>& atlas,
                                                                  const PointSet<m>& points,
                                                                  const std::vector<LabelSimplex<m>>& simplices);

}  // namespace delcert
