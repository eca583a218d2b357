#include "kernel/chart/torus_cells.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
void expect_all_lifts_in_boxes(const Vector<double, m>& widths) {
  std::mt19937 random(1);
  const auto unit = [&random] { return static_cast<double>(random() % 4096) / 4096; };
  TorusCells<m> cells(widths);
  std::vector<Vector<double, m>> points(60);
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    for (double& coordinate : points[index]) coordinate = unit();
    cells.insert(index, points[index]);
  }
  for (int round = 0; round < 20; ++round) {
    // Every second centre is a point, and half-widths are differences of points: ends of boxes are met exactly.
    Vector<double, m> centre = points[static_cast<std::size_t>(round)];
    Vector<double, m> half;
    for (std::size_t axis = 0; axis < m; ++axis) {
      if (round % 2 == 1) centre[axis] = unit();
      half[axis] = round % 5 == 4 ? 1.25 : std::fabs(points[50][axis] - centre[axis]);
    }
    std::set<Lift<m>> found;
    const bool upwards = round % 3 == 0;
    const auto look = [&] {
      cells.visit(centre, half, [&](const Lift<m>& lift) {
        EXPECT_TRUE(found.insert(lift).second);
        return false;
      });
    };
    if (upwards) {
      const RoundingGuard guard;
      look();
    } else {
      look();
    }
    Shift<m> shift;
    shift.fill(-3);
    while (true) {
      for (std::uint32_t index = 0; index < points.size(); ++index) {
        bool is_inside = true;
        for (std::size_t axis = 0; axis < m; ++axis)
          is_inside = is_inside && std::fabs(points[index][axis] + shift[axis] - centre[axis]) <= half[axis];
        if (is_inside) {
          EXPECT_TRUE(found.contains({index, shift}));
        }
      }
      std::size_t axis = 0;
      while (axis < m && ++shift[axis] > 3) shift[axis++] = -3;
      if (axis == m) break;
    }
  }
}

TEST(TorusCells, visit_all_lifts_in_a_box) {
  expect_all_lifts_in_boxes<2>({0.1, 0.3});
  expect_all_lifts_in_boxes<2>({1e-9, 7});
  expect_all_lifts_in_boxes<3>({0.2, 0.5, 0.09});
}

TEST(TorusCells, visit_little_more_and_stop_when_told) {
  TorusCells<2> cells({0.01, 0.01});
  std::uint32_t count = 0;
  for (std::uint32_t row = 0; row < 100; ++row) {
    for (std::uint32_t column = 0; column < 100; ++column) cells.insert(count++, {row / 100.0, column / 100.0});
  }
  std::uint32_t visited = 0;
  cells.visit({0.5, 0.5}, {0.05, 0.05}, [&](const Lift<2>&) { return ++visited == 0; });
  EXPECT_GE(visited, 121U);
  EXPECT_LE(visited, 169U);
  visited = 0;
  cells.visit({0.5, 0.5}, {0.05, 0.05}, [&](const Lift<2>&) { return ++visited == 7; });
  EXPECT_EQ(visited, 7U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
