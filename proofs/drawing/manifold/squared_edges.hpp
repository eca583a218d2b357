#pragma once

#include <array>
#include <cstddef>

namespace delcert {

inline constexpr std::size_t most_vertices_of_a_simplex = 5;

/// Squares of the edges of a simplex, by the numbers of two vertices.
using SquaredEdges = std::array<std::array<double, most_vertices_of_a_simplex>, most_vertices_of_a_simplex>;

/// These, where square(j, k) is that of the edge between vertices j < k of so many.
template <class Square>
[[nodiscard]] SquaredEdges squares_between(std::size_t vertices, const Square& square) {
  SquaredEdges result{};
  for (std::size_t j = 0; j < vertices; ++j) {
    for (std::size_t k = j + 1; k < vertices; ++k) result[j][k] = result[k][j] = square(j, k);
  }
  return result;
}

}  // namespace delcert
