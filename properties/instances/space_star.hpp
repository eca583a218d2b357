#pragma once

#include <optional>

#include "properties/instances/net_star.hpp"
#include "properties/instances/space_object.hpp"

namespace delcert {

/// The star of a point in the Delaunay complex of points in an exponential chart, as far as enclosures can tell.
struct SeenStar {
  StarCells cells;         ///< the m-simplices, by the numbers of their vertices in increasing order; sorted
  BigInterval thickness;   ///< the least of them
  BigInterval protection;  ///< the least |q − C| − R over simplices and other points q, a length
};

/// The star of the first point in the Delaunay complex of all, seen in the exponential chart at the point with the
/// coordinates `centre`. A star of points nearby is found on rational approximations; then every simplex is certified,
/// at the working precision of `BigInterval`, 256 bits at most, to be non-degenerate and to have all other points
/// outside of its sphere, and points that are farther away by their distance alone. Since it is a closed star, there
/// are no other simplices. Nothing where that does not succeed: cospherical points, a point at the boundary,
/// coordinates of length above 1.
[[nodiscard]] std::optional<SeenStar> star_in_chart(const SpaceObject& points, const ExactPoint& centre);

/// The cells at the first point of the Delaunay complex of all in the space, as in `star_cells`: with more than m + 1
/// vertices where points are cospherical. Exact, because in conformal coordinates about the first point spheres are
/// spheres. Nothing if that point is at the boundary, or coordinates or spheres are too large: of length above 1, of
/// radius above 1/2.
[[nodiscard]] std::optional<StarCells> star_in_space(const SpaceObject& points);

}  // namespace delcert
