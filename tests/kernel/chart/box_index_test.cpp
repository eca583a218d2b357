#include "kernel/chart/box_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "kernel/random/counter_random.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Enclosures in the unit cube, some of them wide, some of them points.
std::vector<Vector<Filter, 3>> enclosures(std::size_t count) {
  CounterRandom random(1, RandomPurpose::instances, 7, 0);
  std::vector<Vector<Filter, 3>> result;
  while (result.size() < count) {
    const double width = result.size() % 3 == 0 ? 0 : random.next_unit() / 8;
    Vector<Filter, 3> point;
    for (auto& entry : point) {
      const double lower = random.next_unit();
      entry = Filter::between(lower, lower + width);
    }
    result.push_back(point);
  }
  return result;
}

bool meets(const Vector<Filter, 3>& point, const Vector<double, 3>& lowest, const Vector<double, 3>& highest) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (point[axis].upper() < lowest[axis] || point[axis].lower() > highest[axis]) return false;
  }
  return true;
}

TEST(BoxIndex, finds_what_looking_at_every_point_finds) {
  const FilterGuard guard;
  const auto points = enclosures(200);
  BoxIndex<3> index;
  index.fill(points);
  CounterRandom random(1, RandomPurpose::instances, 8, 0);
  std::size_t some = 0;
  for (std::size_t box = 0; box < points.size(); ++box) {
    Vector<double, 3> lowest;
    Vector<double, 3> highest;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lowest[axis] = random.next_unit();
      highest[axis] = lowest[axis] + random.next_unit() / 3;
    }
    // Ends of enclosures on the sides of the box belong to it.
    if (box % 5 == 0) lowest[0] = points[box][0].upper();
    if (box % 5 == 1) highest[0] = points[box][0].lower();
    std::vector<std::uint32_t> expected;
    for (std::uint32_t at = 0; at < points.size(); ++at) {
      if (meets(points[at], lowest, highest)) expected.push_back(at);
    }
    std::vector<std::uint32_t> found;
    index.meeting(lowest, highest, found);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                               [&](auto a, auto b) { return points[a][0].lower() < points[b][0].lower(); }));
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    if (!found.empty()) ++some;
  }
  EXPECT_GT(some, 100U);
}

TEST(BoxIndex, takes_unbounded_boxes_and_enclosures) {
  const FilterGuard guard;
  auto points = enclosures(20);
  points[5][0] = Filter::between(-infinity, infinity);
  BoxIndex<3> index;
  index.fill(points);
  std::vector<std::uint32_t> found;
  index.meeting({2, 0, 0}, {3, 1, 1}, found);
  EXPECT_EQ(found, std::vector<std::uint32_t>{5});
  index.meeting({-infinity, -infinity, -infinity}, {infinity, infinity, infinity}, found);
  EXPECT_EQ(found.size(), points.size());
  index.fill({});
  index.meeting({0, 0, 0}, {1, 1, 1}, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
