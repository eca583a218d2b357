#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/simplex/vector.hpp"
#include "properties/instances/net_object.hpp"

namespace delcert {

/// The maximal cells of the Delaunay complex at one point: for each vertex of its Voronoi cell the points, by number in
/// increasing order, on the empty sphere about it. More than m + 1 of them where the points are cospherical. The star
/// of the point consists of the subsets of the cells that contain it, and their faces.
using StarCells = std::vector<std::vector<std::uint32_t>>;

/// The cells at the first point of a set, sorted. Exact, by trying all m-sets of the points around it; a set of points
/// around suffices when their Voronoi cell is bounded and in a ball of half the distance within which all were taken.
/// Nothing if the point is not inside the convex hull of the 30 points nearest to it, or 300 (in ℝ³ 160) points around
/// it do not suffice. `distance`: where to begin, about twice the largest circumradius.
template <int m>
[[nodiscard]] std::optional<StarCells> star_cells(const std::vector<Vector<Rational, m>>& points,
                                                  const Rational& distance);

}  // namespace delcert
