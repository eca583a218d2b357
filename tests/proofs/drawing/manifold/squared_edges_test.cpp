#include "proofs/drawing/manifold/squared_edges.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(SquaredEdges, AreTheSameBothWaysAndZeroElsewhere) {
  const SquaredEdges squares =
      squares_between(3, [](std::size_t j, std::size_t k) { return static_cast<double>(10 * j + k); });
  for (std::size_t j = 0; j < most_vertices_of_a_simplex; ++j) {
    for (std::size_t k = 0; k < most_vertices_of_a_simplex; ++k) {
      const bool is_edge = j != k && j < 3 && k < 3;
      const std::size_t expected = j < k ? 10 * j + k : 10 * k + j;
      EXPECT_EQ(squares[j][k], is_edge ? static_cast<double>(expected) : 0.0);
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
