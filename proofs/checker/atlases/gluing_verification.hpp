#pragma once

#include <string>

#include "proofs/checker/atlases/gluing_cells.hpp"

namespace delcert::checker {

/// That boxes glued by passages that are all inverse to one another in pairs are a closed manifold: atlas.cocycle,
/// atlas.hausdorff, atlas.compact. Throws Undecided.
std::string check_gluing(const Gluing& gluing, const std::vector<Passage>& passages, Report& report);

}  // namespace delcert::checker
