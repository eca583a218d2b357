#include "kernel/chart/ambient_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/random/counter_random.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(AmbientGrid, finds_what_is_within_a_distance_in_any_dimension) {
  for (const std::size_t dimension : {1U, 2U, 3U, 6U, 9U}) {
    AmbientGrid grid(dimension, 0.4);
    CounterRandom random(1, RandomPurpose::instances, static_cast<std::uint32_t>(dimension), 0);
    constexpr std::uint32_t count = 300;
    for (std::uint32_t point = 0; point < count; ++point) {
      std::vector<double> x(dimension);
      for (double& coordinate : x) coordinate = 2 * random.next_unit() - 1;
      grid.insert(x.data());
    }
    ASSERT_EQ(grid.size(), count);
    for (const double distance : {0.05, 0.4, 0.7}) {
      for (std::uint32_t from = 0; from < count; from += 30) {
        std::vector<std::uint32_t> found;
        grid.visit(grid[from], distance, [&](std::uint32_t point, double) {
          found.push_back(point);
          return false;
        });
        std::sort(found.begin(), found.end());
        std::vector<std::uint32_t> expected;
        for (std::uint32_t point = 0; point < count; ++point) {
          double squared = 0;
          for (std::size_t axis = 0; axis < dimension; ++axis)
            squared += (grid[point][axis] - grid[from][axis]) * (grid[point][axis] - grid[from][axis]);
          if (squared <= distance * distance) expected.push_back(point);
        }
        EXPECT_EQ(found, expected);
      }
    }
  }
}

TEST(AmbientGrid, stops_when_told_and_tells_distances) {
  AmbientGrid grid(2, 1);
  for (const double x : {0.0, 3.0, 4.0}) grid.insert(std::vector<double>{x, 0}.data());
  const std::vector<double> from{0, 4};
  int visits = 0;
  grid.visit(from.data(), 6, [&](std::uint32_t, double) { return ++visits == 2; });
  EXPECT_EQ(visits, 2);
  grid.visit(from.data(), 4.5, [&](std::uint32_t point, double squared) {
    EXPECT_EQ(point, 0U);
    EXPECT_EQ(squared, 16);
    return false;
  });
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
