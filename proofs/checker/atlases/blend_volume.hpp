#pragma once

#include "proofs/checker/atlases/gluing_cells.hpp"

namespace delcert::checker {

/// A simplex whose vertices are at home in one or the other of two charts.
struct SimplexOfTwoHomes {
  std::vector<Cell> here, there;  // the vertices in the first chart and in the second one
  std::vector<bool> first;        // whether the first one is the home
};

/// Whether what the blend makes of volumes, det F of docs/levels/atlases.md, is certainly at least this on all of the
/// simplex. The passage, from the first chart to the second one, has one piece; m = 2, 3.
bool is_blend_volume_at_least(const SimplexOfTwoHomes& simplex, PassageValues& passage, const Interval& least);

}  // namespace delcert::checker
