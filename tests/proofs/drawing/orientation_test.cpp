#include "proofs/drawing/orientation.hpp"

#include <gtest/gtest.h>

#include <map>

namespace delcert {
namespace DELCERT_THIS_FILE {

/// Of triangles: whether no directed edge is there twice.
bool is_coherent(const std::vector<std::uint32_t>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t at = 0; at < triangles.size(); at += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (++edges[{triangles[at + k], triangles[at + (k + 1) % 3]}] > 1) return false;
    }
  }
  return true;
}

TEST(Orientation, OfATetrahedronsBoundary) {
  std::vector<std::uint32_t> triangles{1, 2, 3, 0, 2, 3, 0, 1, 3, 0, 1, 2};
  EXPECT_FALSE(is_coherent(triangles));
  EXPECT_TRUE(orient_coherently(triangles, 3));
  EXPECT_TRUE(is_coherent(triangles));
  const std::vector<std::uint32_t> before = triangles;
  reverse_orientation(triangles, 3);
  EXPECT_NE(triangles, before);
  EXPECT_TRUE(is_coherent(triangles));
}

TEST(Orientation, OfTheProjectivePlaneThereIsNone) {
  std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 1, 5,
                                       1, 2, 4, 2, 3, 5, 1, 3, 4, 2, 4, 5, 1, 3, 5};
  EXPECT_FALSE(orient_coherently(triangles, 3));
}

TEST(Orientation, OfTheBoundaryOfA4Simplex) {
  std::vector<std::uint32_t> tetrahedra;
  for (std::uint32_t without = 0; without < 5; ++without) {
    for (std::uint32_t k = 0; k < 5; ++k) {
      if (k != without) tetrahedra.push_back(k);
    }
  }
  const std::vector<std::uint32_t> before = tetrahedra;
  EXPECT_TRUE(orient_coherently(tetrahedra, 4));
  // Signs alternate: two of the five are turned, or the other three.
  int turned = 0;
  for (std::size_t at = 0; at < 5; ++at) turned += tetrahedra[4 * at + 3] != before[4 * at + 3];
  EXPECT_EQ(turned, 2);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
