#include "properties/instances/net_star.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/stars/approximate_delaunay.hpp"
#include "properties/instances/choices.hpp"
#include "tests/properties/instances/square_net.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Random points, short dyadics in the unit ball, the origin first.
template <int m>
std::vector<Vector<Rational, m>> random_points(std::uint32_t number, std::size_t count) {
  RandomChoices choices(1, 2, number);
  std::vector<Vector<Rational, m>> points{Vector<Rational, m>{}};
  while (points.size() < count) {
    Vector<Rational, m> point;
    for (Rational& coordinate : point) coordinate = choices.symmetric(20);
    points.push_back(point);
  }
  return points;
}

/// The cells at point 0 as CGAL has them, for points in general position.
template <int m>
StarCells independent_cells(const std::vector<Vector<Rational, m>>& points) {
  std::vector<Vector<double, m>> doubles;
  for (const auto& point : points) {
    Vector<double, m> approximate;
    for (std::size_t axis = 0; axis < m; ++axis) approximate[axis] = approximate_double(point[axis]);
    doubles.push_back(approximate);
  }
  StarCells result;
  for (const auto& simplex : approximate_delaunay<m>(doubles)) {
    if (simplex[0] == 0) result.emplace_back(simplex.begin(), simplex.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <int m>
void compare_stars(std::uint32_t number, std::size_t count) {
  const auto points = random_points<m>(number, count);
  const auto cells = star_cells<m>(points, Rational::power_of_two(-2));
  ASSERT_TRUE(cells.has_value());
  EXPECT_EQ(*cells, independent_cells<m>(points));
}

TEST(StarCells, of_a_point_in_one_triangle_of_either_orientation_are_three) {
  for (const int side : {1, -1}) {
    const auto at = [side](int x, int y) { return Vector<Rational, 2>{Rational(x), Rational(side * y)}; };
    const auto cells = star_cells<2>({at(0, 0), at(1, 0), at(-1, 2), at(-1, -3)}, Rational(1));
    EXPECT_EQ(cells, (StarCells{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}})) << side;
  }
}

TEST(StarCells, of_the_square_lattice_are_four_squares) {
  const auto points = square_vectors(3);
  const auto cells = star_cells<2>(points, Rational(2));
  ASSERT_TRUE(cells.has_value());
  ASSERT_EQ(cells->size(), 4U);
  for (const auto& cell : *cells) {
    ASSERT_EQ(cell.size(), 4U);
    EXPECT_EQ(cell[0], 0U);
    for (const std::uint32_t at : cell) {
      for (const Rational& coordinate : points[at]) EXPECT_LE(absolute(coordinate), Rational(1));
    }
  }
}

TEST(StarCells, are_those_of_another_triangulation_for_random_points) {
  for (std::uint32_t number = 0; number < 12; ++number) {
    compare_stars<2>(number, 120);
    compare_stars<3>(number, 100);
  }
}

TEST(StarCells, do_not_depend_on_where_the_search_begins) {
  const auto points = random_points<2>(77, 200);
  EXPECT_EQ(star_cells<2>(points, Rational::power_of_two(-8)), star_cells<2>(points, Rational(1)));
}

TEST(StarCells, are_none_at_a_point_of_the_boundary) {
  auto points = square_vectors(3);
  std::swap(points[0], points[1]);
  EXPECT_FALSE(star_cells<2>(points, Rational(2)).has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
