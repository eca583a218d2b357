#pragma once

#include <array>
#include <cstddef>

namespace delcert {

/// A simplex by the squares of its edges, in doubles, without error bounds.
struct ApproximateShape {
  static constexpr std::size_t most_vertices = 5;
  using Numbers = std::array<double, most_vertices>;

  double thickness = 0;     ///< least altitude / (m · longest edge)
  double circumradius = 0;  ///< of the circumscribed ball in the simplex's own plane
  Numbers centre{};         ///< barycentric coordinates of the circumcentre
  Numbers altitudes{};      ///< at each vertex
};

/// Squares of edges, by the numbers of two vertices.
using SquaredEdges = std::array<std::array<double, ApproximateShape::most_vertices>, ApproximateShape::most_vertices>;

/// Of the simplex with m + 1 vertices, 1 ≤ m ≤ 4. All is NaN if it is degenerate to double precision.
[[nodiscard]] ApproximateShape approximate_shape(std::size_t m, const SquaredEdges& squares);

}  // namespace delcert
