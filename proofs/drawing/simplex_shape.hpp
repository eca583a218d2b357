#pragma once

#include <array>
#include <cstddef>

#include "proofs/drawing/manifold/squared_edges.hpp"

namespace delcert {

/// A simplex by the squares of its edges, in doubles, without error bounds.
struct ApproximateShape {
  static constexpr std::size_t most_vertices = most_vertices_of_a_simplex;
  using Numbers = std::array<double, most_vertices>;

  double thickness = 0;     ///< least altitude / (m · longest edge)
  double circumradius = 0;  ///< of the circumscribed ball in the simplex's own plane
  Numbers centre{};         ///< barycentric coordinates of the circumcentre
  Numbers altitudes{};      ///< at each vertex
};

/// Of the simplex with m + 1 vertices, 1 ≤ m ≤ 4. All is NaN if it is degenerate to double precision.
[[nodiscard]] ApproximateShape approximate_shape(std::size_t m, const SquaredEdges& squares);

}  // namespace delcert
