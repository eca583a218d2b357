#include "kernel/sample/spatial_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel/random/counter_random.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(SpatialOrder, is_that_of_morton) {
  // Low axes change first.
  const std::vector<std::array<double, 2>> points{{0.5, 0.5}, {0.5, -0.5}, {-0.5, 0.5}, {-0.5, -0.5}};
  EXPECT_EQ(spatial_order(points), (std::vector<std::uint32_t>{3, 1, 2, 0}));
}

TEST(SpatialOrder, takes_what_is_outside_to_the_border) {
  const std::vector<std::array<double, 2>> points{{5, 5}, {1, 1}, {-7, 0.25}, {-1, 0.25}};
  EXPECT_EQ(spatial_order(points), (std::vector<std::uint32_t>{2, 3, 0, 1}));
}

TEST(SpatialOrder, keeps_points_of_a_sphere_together) {
  std::vector<Vector<double, 2>> points;
  for (std::uint32_t label = 0; label < 500; ++label) {
    CounterRandom random(1, RandomPurpose::instances, label, 0);
    points.push_back({40 * random.next_unit() - 20, 40 * random.next_unit() - 20});
  }
  const auto order = spatial_order_of_lifts<2>(Curvature::positive, points);
  auto sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t label = 0; label < 500; ++label) EXPECT_EQ(sorted[label], label);
  const auto place = [&](std::uint32_t label) {
    const double deviation = pairing(points[label], points[label]) / 4;
    return std::array<double, 3>{(1 - deviation) / (1 + deviation), points[label][0] / (1 + deviation),
                                 points[label][1] / (1 + deviation)};
  };
  double ordered = 0;
  double unordered = 0;
  for (std::uint32_t at = 1; at < 500; ++at) {
    const auto step = difference(place(order[at]), place(order[at - 1]));
    const auto jump = difference(place(at), place(at - 1));
    ordered += std::sqrt(pairing(step, step));
    unordered += std::sqrt(pairing(jump, jump));
  }
  EXPECT_LT(ordered, unordered / 3);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
