#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/manifold/submanifold/triangle_mesh.hpp"

namespace delcert {

/// Rule mesh.closed: for each facet those with an edge of it, in the order of its edges, from the first vertex to the
/// second on. Throws Rejection, which begins with the name and names facets or an edge, unless every facet has an area
/// and every edge is in exactly two of them, in opposite directions.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> neighbours_if_closed(const std::string& name,
                                                                             const TriangleMesh& mesh);

}  // namespace delcert
