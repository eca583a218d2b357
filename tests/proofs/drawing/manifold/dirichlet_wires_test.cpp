#include "proofs/drawing/manifold/dirichlet_wires.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delcert {
namespace DELCERT_THIS_FILE {

double length_of(const std::vector<std::pair<Motions::Vector, Motions::Vector>>& wires) {
  double sum = 0;
  for (const auto& [from, to] : wires) sum += std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  return sum;
}

TEST(DirichletWires, OfASquareAndOfACube) {
  // |y_k| ≤ 1/2.
  const auto square = wires_between({{0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}, {0.5, 0, -1}}, 2, 0);
  EXPECT_NEAR(length_of(square), 4, 1e-9);
  std::vector<Motions::Vector> walls;
  for (std::size_t axis = 1; axis <= 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      walls.push_back({0.5});
      walls.back()[axis] = sign;
    }
  }
  // A wall that cuts nothing off changes nothing.
  walls.push_back({2, 1, 1, 1});
  double sum = 0;
  for (const auto& [from, to] : wires_between(walls, 3, 0)) {
    EXPECT_EQ(from[0], 1);
    sum += std::hypot(to[1] - from[1], to[2] - from[2], to[3] - from[3]);
  }
  EXPECT_NEAR(sum, 12, 1e-9);
}

TEST(DirichletWires, OfAHalfSphereAreItsEquator) {
  const auto equator = wires_between({{2, 0, 0}}, 2, 1);
  ASSERT_FALSE(equator.empty());
  for (const auto& [from, to] : equator) {
    EXPECT_NEAR(from[0], 0, 1e-12);
    EXPECT_NEAR(std::hypot(to[1], to[2]), 1, 1e-12);
  }
  EXPECT_TRUE(wires_between({}, 2, 1).empty());
}

TEST(DirichletWires, OfAHyperbolicSquareLieOnTheHyperboloid) {
  const auto square = wires_between({{0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}, {0.5, 0, -1}}, 2, -1);
  ASSERT_FALSE(square.empty());
  for (const auto& [from, to] : square) {
    EXPECT_NEAR(from[0] * from[0] - from[1] * from[1] - from[2] * from[2], 1, 1e-9);
    EXPECT_NEAR(std::max(std::fabs(to[1]), std::fabs(to[2])) / to[0], 0.5, 1e-9);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
