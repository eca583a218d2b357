#include "properties/instances/configuration_skeleton.hpp"

#include <gtest/gtest.h>

#include "properties/instances/exact_point.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

constexpr std::uint32_t draws = 40;

/// (1 − q²)/(1 + q²).
Rational height_of_parallel(const Rational& q) { return (Rational(1) - square(q)) / (Rational(1) + square(q)); }

TEST(ConfigurationSkeleton, PointsLieOnTheUnitSphere) {
  for (const std::size_t k : {std::size_t{2}, std::size_t{3}, std::size_t{4}}) {
    for (std::uint32_t number = 0; number < draws; ++number) {
      RandomChoices choices(1, static_cast<std::uint32_t>(k), number);
      const auto skeleton = draw_configuration_skeleton(k, choices);
      EXPECT_EQ(skeleton.points.size(), k + 2);
      EXPECT_TRUE(k > 2 || !skeleton.is_sliver);
      for (const auto& point : skeleton.points) {
        EXPECT_EQ(point.size(), k);
        EXPECT_EQ(pairing(point, point), Rational(1));
      }
    }
  }
}

TEST(ConfigurationSkeleton, DirectionsStayWhereTheyAreWithoutJitter) {
  RandomChoices choices(1, 2, 3);
  const auto points = jittered(spread_directions(2, true), 0.0, choices);
  const SimplexObject::Points expected{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  EXPECT_EQ(points, expected);
  EXPECT_NE(jittered(spread_directions(2, true), 0.25, choices), expected);
}

TEST(ConfigurationSkeleton, SliversLieOnTheirParallelUntilTheyAreTilted) {
  std::uint32_t slivers = 0;
  for (std::uint32_t number = 0; number < draws; ++number) {
    RandomChoices choices(1, 3, number);
    auto skeleton = draw_configuration_skeleton(3, choices);
    if (!skeleton.is_sliver) continue;
    ++slivers;
    EXPECT_EQ(skeleton.sliver().size(), 4U);
    for (const auto& point : skeleton.sliver()) EXPECT_EQ(point.back(), height_of_parallel(skeleton.parallel));
    const Rational tilt = Rational(1) / Rational(1000);
    skeleton.tilt_by(tilt);
    EXPECT_EQ(skeleton.sliver().back().back(), height_of_parallel(skeleton.parallel + tilt));
    EXPECT_EQ(skeleton.sliver().front().back(), height_of_parallel(skeleton.parallel));
  }
  EXPECT_GT(slivers, draws / 4);
  EXPECT_LT(slivers, draws * 3 / 4);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
