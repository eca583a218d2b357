#pragma once

#include <utility>
#include <vector>

#include "proofs/drawing/manifold/motions.hpp"

namespace delcert {

/// The edges (m = 3) or sides (m = 2) of the polyhedron {x: w(x) ≥ 0 for all walls w} in the model x₀² + K|y|² = 1 (of
/// curvature 0: x₀ = 1), in short pieces along geodesics. Walls are rows of m + 1 numbers. In doubles, for the eye.
[[nodiscard]] std::vector<std::pair<Motions::Vector, Motions::Vector>> wires_between(
    const std::vector<Motions::Vector>& walls, std::size_t m, int curvature);

}  // namespace delcert
