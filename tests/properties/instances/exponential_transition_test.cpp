#include "properties/instances/exponential_transition.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "properties/instances/configuration_finite_map.hpp"
#include "properties/instances/exact_point.hpp"
#include "properties/instances/map_object.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational half(long numerator) { return Rational(numerator) / Rational(2); }

/// Four points next to a circle, off the origin, in the plane or in space.
SimplexObject::Points four_points(std::size_t m) {
  const Rational near = Rational(1) + Rational::power_of_two(-10);
  SimplexObject::Points result = {
      {2, 1}, {1, 2}, {Rational(1) - near, 1}, {Rational(8) / Rational(5), Rational(1) / Rational(5)}};
  for (auto& point : result) point.resize(m, Rational(0));
  return result;
}

SpaceObject space_with(Curvature curvature, ExactPoint centre) {
  const ExactPoint origin(centre.size(), Rational(0));
  return {curvature, Rational(3), {origin, std::move(centre)}};
}

TEST(ExponentialTransition, comes_near_the_distortion_and_keeps_to_it) {
  for (const long exponent : {-2L, -40L, -300L}) {
    const Rational distortion = Rational::power_of_two(exponent);
    int found = 0;
    int near = 0;
    std::map<Curvature, int> curvatures;
    for (std::uint32_t number = 0; number < 30; ++number) {
      RandomChoices choices(1, 1, number);
      const auto points = four_points(number % 2 == 0 ? 2 : 3);
      const auto transition = exponential_transition(points, distortion, Rational(4), choices);
      if (!transition) continue;
      ++found;
      ++curvatures[transition->space->curvature()];
      EXPECT_TRUE(is_distorted_at_most(transition->map));
      EXPECT_EQ(transition->map.points.size(), points.size() + 4);
      EXPECT_TRUE(is_transition_of(*transition->space, transition->map));
      ConfigurationMap::Finite claimed = transition->map;
      claimed.distortion = distortion * Rational(7) / Rational(8);
      near += is_distorted_at_most(claimed) ? 0 : 1;
    }
    EXPECT_GE(found, 25) << exponent;
    EXPECT_GE(near, 15) << exponent;
    EXPECT_GE(curvatures[Curvature::positive], 5) << exponent;
    EXPECT_GE(curvatures[Curvature::negative], 5) << exponent;
  }
}

TEST(ExponentialTransition, of_what_needs_thousands_of_digits_there_is_none) {
  RandomChoices choices(1, 1, 0);
  EXPECT_FALSE(exponential_transition(four_points(2), Rational::power_of_two(-901), Rational(4), choices));
  const auto space = space_with(Curvature::positive, {half(1), 0});
  EXPECT_TRUE(rounded_transition(space, four_points(2), Rational::power_of_two(-3000)));
  EXPECT_FALSE(rounded_transition(space, four_points(2), Rational::power_of_two(-5000)));
}

TEST(ExponentialTransition, with_one_centre_is_the_identity) {
  const auto space = space_with(Curvature::negative, {0, 0, 0});
  const auto map = rounded_transition(space, four_points(3), Rational::power_of_two(-20));
  ASSERT_TRUE(map);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(squared_distance_between(map->points[i], map->images[i]), Rational::power_of_two(-100));
  }
}

/// The law of cosines for the distance from the centre i, in doubles.
TEST(ExponentialTransition, sees_points_as_far_from_the_other_centre_as_they_are) {
  for (const Curvature curvature : {Curvature::positive, Curvature::negative}) {
    const double sign = sign_of(curvature);
    const auto space = space_with(curvature, {half(1), 0});
    const auto map = rounded_transition(space, four_points(2), Rational::power_of_two(-20));
    ASSERT_TRUE(map);
    constexpr double unit = 3;
    const double to_centre = sign > 0 ? 2 * std::atan(0.25) : 2 * std::atanh(0.25);
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = approximate_double(map->points[i][0]) / unit;
      const double y = approximate_double(map->points[i][1]) / unit;
      const double distance = std::hypot(x, y);
      const double cosine = x / distance;
      const double seen = std::sqrt(approximate_double(pairing(map->images[i], map->images[i]))) / unit;
      const double expected =
          sign > 0
              ? std::acos(std::cos(to_centre) * std::cos(distance) + std::sin(to_centre) * std::sin(distance) * cosine)
              : std::acosh(std::cosh(to_centre) * std::cosh(distance) -
                           std::sinh(to_centre) * std::sinh(distance) * cosine);
      EXPECT_NEAR(seen, expected, 1e-9) << sign << " " << i;
    }
  }
}

TEST(ExponentialTransition, another_image_or_another_space_is_noticed) {
  const auto space = space_with(Curvature::positive, {half(1), half(1)});
  const auto map = rounded_transition(space, four_points(2), Rational::power_of_two(-20));
  ASSERT_TRUE(map);
  EXPECT_TRUE(is_transition_of(space, *map));
  EXPECT_FALSE(is_transition_of(space_with(Curvature::negative, {half(1), half(1)}), *map));
  EXPECT_FALSE(is_transition_of(space_with(Curvature::positive, {half(1), half(-1)}), *map));
  ConfigurationMap::Finite changed = *map;
  changed.images[2][1] += Rational::power_of_two(-60);
  EXPECT_FALSE(is_transition_of(space, changed));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
