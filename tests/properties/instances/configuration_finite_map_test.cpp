#include "properties/instances/configuration_finite_map.hpp"

#include <gtest/gtest.h>

#include "properties/instances/exact_point.hpp"
#include "properties/instances/map_object.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// Four points next to the unit circle, in the plane or in space.
SimplexObject::Points four_points(std::size_t m) {
  const Rational near = Rational(1) + Rational::power_of_two(-10);
  SimplexObject::Points result = {{1, 0}, {0, 1}, {-near, 0}, {Rational(3) / Rational(5), Rational(-4) / Rational(5)}};
  for (auto& point : result) point.resize(m, Rational(0));
  return result;
}

TEST(ConfigurationFiniteMap, circumcentres_are_those_of_the_facets) {
  const auto centres = circumcentres_of_facets(four_points(2));
  // Without the third point the others are on the unit circle.
  ASSERT_EQ(centres.size(), 4U);
  EXPECT_EQ(centres[2], (ExactPoint{0, 0}));
  // Four points of one circle have one.
  SimplexObject::Points round = four_points(2);
  round[2] = {-1, 0};
  EXPECT_EQ(circumcentres_of_facets(round).size(), 1U);
}

TEST(ConfigurationFiniteMap, maps_come_near_the_distortion_and_keep_to_it) {
  const Rational distortion = Rational::power_of_two(-40);
  int found = 0;
  int far = 0;
  for (std::uint32_t number = 0; number < 60; ++number) {
    RandomChoices choices(1, 1, number);
    const std::size_t m = number % 2 == 0 ? 2 : 3;
    const auto points = four_points(m);
    const auto map = finite_configuration_map(points, distortion, choices);
    if (!map) continue;
    ++found;
    EXPECT_NO_THROW(ConfigurationMap{*map});
    EXPECT_EQ(map->points.size(), points.size() + 4);
    // With a fifth of the certificate it is refused.
    ConfigurationMap::Finite claimed = *map;
    claimed.distortion = distortion / Rational(5);
    EXPECT_THROW(ConfigurationMap{claimed}, InputError);
    Rational farthest(0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      farthest = maximum(farthest, squared_distance_between(map->points[i], map->images[i]));
    }
    far += m == 3 && farthest > Rational::power_of_two(-46) ? 1 : 0;
  }
  EXPECT_GT(found, 40);
  // Off the plane, vertices move some √ξ = 2⁻²⁰.
  EXPECT_GT(far, 2);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
