#pragma once

#include <vector>

#include "proofs/drawing/figure/point_figure.hpp"
#include "properties/attack/witness.hpp"

namespace delcert {

/// All that can be drawn of an instance: simplices, points, nets, each named by the way to it in the witness file. A
/// simplex that is known by the squares of its edges is placed in the space of its dimension. In doubles; what
/// is beyond their range is left out. Empty if the instance is numbers alone.
[[nodiscard]] std::vector<DrawnSet> drawn_sets(const Witness& witness);

}  // namespace delcert
