#include "kernel/stars/approximate_star.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
std::vector<IndexSimplex<m>> slow_star(const std::vector<Vector<double, m>>& points, std::uint32_t home) {
  std::vector<IndexSimplex<m>> result;
  for (const auto& simplex : approximate_delaunay<m>(points)) {
    if (std::find(simplex.begin(), simplex.end(), home) != simplex.end()) result.push_back(simplex);
  }
  return result;
}

template <int m>
std::vector<Vector<double, m>> random_points(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Vector<double, m>> result(count);
  for (auto& point : result) {
    for (double& x : point) x = coordinate(random);
  }
  return result;
}

/// Of every point: inside the hull, and on it, where the star is no sphere.
template <int m>
void check(const std::vector<Vector<double, m>>& points) {
  for (std::uint32_t home = 0; home < points.size(); ++home)
    EXPECT_EQ(approximate_star<m>(points, home), slow_star<m>(points, home)) << home;
}

TEST(ApproximateStar, is_that_of_the_triangulation) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    check<1>(random_points<1>(20, seed));
    check<2>(random_points<2>(5, seed));
    check<2>(random_points<2>(60, seed));
    check<3>(random_points<3>(6, seed));
    check<3>(random_points<3>(60, seed));
    check<4>(random_points<4>(12, seed));
  }
}

/// A lattice has cospherical points everywhere; displaced by little, nearly so.
template <int m>
std::vector<Vector<double, m>> lattice(double displacement) {
  auto result = random_points<m>(m == 2 ? 25 : 125, 4);
  for (std::size_t number = 0; number < result.size(); ++number) {
    std::size_t rest = number;
    for (double& x : result[number]) {
      x = static_cast<double>(rest % 5) + displacement * x;
      rest /= 5;
    }
  }
  return result;
}

TEST(ApproximateStar, of_cospherical_points_is_that_of_the_triangulation) {
  for (const double displacement : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.1}) {
    check<2>(lattice<2>(displacement));
    check<3>(lattice<3>(displacement));
  }
}

TEST(ApproximateStar, of_points_that_are_near_each_other_is_that_of_the_triangulation) {
  auto plane = random_points<2>(30, 5);
  auto solid = random_points<3>(30, 5);
  for (const double distance : {1e-3, 1e-7, 0.0}) {
    plane.push_back(sum(plane[3], Vector<double, 2>{distance, distance / 2}));
    solid.push_back(sum(solid[3], Vector<double, 3>{distance, distance / 2, distance / 3}));
  }
  plane.pop_back();
  solid.pop_back();
  check<2>(plane);
  check<3>(solid);
  // Of points that coincide only one is used.
  plane.push_back(plane[7]);
  check<2>(plane);
  check<2>({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
}

/// The twin: another point's star is another.
TEST(ApproximateStar, is_of_the_point_that_is_asked_for) {
  const auto points = random_points<3>(40, 8);
  EXPECT_NE(approximate_star<3>(points, 0), slow_star<3>(points, 1));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
