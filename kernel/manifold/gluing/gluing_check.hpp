#pragma once

#include "kernel/manifold/gluing/chart_gluing.hpp"

namespace delcert {

/// How many cells it took.
struct GluingReport {
  std::size_t cocycle_cells = 0;
  std::size_t hausdorff_cells = 0;
  std::size_t compact_cells = 0;
};

/// Verifies that charts glued by their transitions are a closed manifold, the boxes its charts (docs/atlases.md):
/// atlas.cocycle, atlas.hausdorff, atlas.compact, each on cells that are divided until all is certain.
///
/// Throws Rejection, with the rule, the transitions and the cell, where a rule certainly fails; Undecided, with the
/// same, where cells have become small, or many, and nothing is certain. Precondition: rounding to nearest.
[[nodiscard]] GluingReport check_gluing(const ChartGluing& gluing);

}  // namespace delcert
