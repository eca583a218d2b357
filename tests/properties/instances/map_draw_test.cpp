#include "properties/instances/map_draw.hpp"

#include "properties/instances/random_simplex.hpp"
#include "tests/properties/instances/class_checks.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

CentredSimplex edge_and_centre() {
  // r² = 1 + 4.
  return {{{Rational(-1), Rational(0)}, {Rational(1), Rational(0)}},
          {Rational(0), Rational(2)},
          {Rational(0), Rational(0)},
          Rational(5),
          Rational(4)};
}

TEST(MapDraw, CentresAreEquidistantFromTheVertices) {
  for (std::uint32_t number = 0; number < 40; ++number) {
    RandomChoices choices(1, 1, number);
    const auto points = random_simplex({2, 4}, choices);
    if (!points) continue;
    const auto centred = with_centre(SimplexObject(*points), number % 4 == 0, choices);
    ASSERT_TRUE(centred.has_value());
    for (const auto& point : *points)
      EXPECT_EQ(squared_distance_between(point, centred->centre), centred->squared_radius);
    EXPECT_EQ(number % 4 == 0, centred->centre == centred->smallest);
  }
  RandomChoices choices(1, 1, 0);
  const SimplexObject collinear({{Rational(0), Rational(0)}, {Rational(1), Rational(0)}, {Rational(2), Rational(0)}});
  EXPECT_FALSE(with_centre(collinear, true, choices).has_value());
}

TEST(MapDraw, EveryMapKeepsItsDistortion) {
  for (std::uint32_t number = 0; number < 60; ++number) {
    RandomChoices choices(2, 1, number);
    const Rational xi = Rational::power_of_two(-1 - static_cast<long>(number % 20) * 10);
    const auto points = random_simplex({2, 3}, choices);
    if (!points) continue;
    const auto centred = *with_centre(SimplexObject(*points), false, choices);
    EXPECT_TRUE(MapObject(random_linear_map(3, xi, choices)).has_distortion(xi));
    EXPECT_TRUE(MapObject(random_smooth_map(centred, xi, choices)).has_distortion(xi));
    const MapObject inversion(random_inversion(centred, xi, choices));
    EXPECT_TRUE(inversion.has_distortion(xi));
    EXPECT_TRUE(inversion.is_in_domain(centred.centre));
    EXPECT_TRUE(MapObject(displaced_points(centred, xi, choices)).has_distortion(xi));
    EXPECT_TRUE(MapObject(lifted_centre(centred, xi, choices).value()).has_distortion(xi));
    const MapObject outside(with_centre_outside(centred, choices));
    EXPECT_TRUE(outside.has_distortion(Rational(0)));
    EXPECT_FALSE(outside.is_in_domain(centred.centre));
  }
}

TEST(MapDraw, TiltedAndLiftedCentresReachTheDistortion) {
  RandomChoices choices(3, 1, 0);
  const Rational xi = ratio(1, 16);
  const Rational nearly = xi * (Rational(1) - Rational::power_of_two(-40));
  const CentredSimplex simplex = edge_and_centre();
  const FiniteMap tilted = tilted_centre(simplex, xi, choices).value();
  EXPECT_TRUE(MapObject(tilted).has_distortion(xi));
  EXPECT_FALSE(MapObject(tilted).has_distortion(nearly));
  const Rational near = squared_distance_between(tilted.images[2], tilted.images[0]);
  const Rational far = squared_distance_between(tilted.images[2], tilted.images[1]);
  const Rational expected = square(Rational(1) + xi) / square(Rational(1) - xi);
  EXPECT_LT(absolute(maximum(near, far) / minimum(near, far) - expected), Rational::power_of_two(-38));
  const FiniteMap lifted = lifted_centre(simplex, xi, choices).value();
  EXPECT_TRUE(MapObject(lifted).has_distortion(xi));
  EXPECT_FALSE(MapObject(lifted).has_distortion(nearly));
  CentredSimplex filling = simplex;
  filling.points = {{Rational(-1)}, {Rational(1)}};
  filling.centre = filling.smallest = {Rational(0)};
  filling.squared_radius = Rational(1);
  EXPECT_FALSE(lifted_centre(filling, xi, choices).has_value());
  EXPECT_FALSE(tilted_centre(filling, xi, choices).has_value());
}

TEST(MapDraw, DistortionsAreCertifiedAndNotMuchTooLarge) {
  for (std::uint32_t number = 0; number < 40; ++number) {
    RandomChoices choices(4, 1, number);
    const Rational xi = Rational::power_of_two(-4 - static_cast<long>(number) * 7);
    const MapObject moved(displaced_points(edge_and_centre(), xi, choices));
    const Rational measured = certified_distortion(moved, xi);
    EXPECT_TRUE(moved.has_distortion(measured));
    EXPECT_FALSE(moved.has_distortion(measured * (Rational(1) - Rational::power_of_two(-38))));
    const MapObject inversion(random_inversion(edge_and_centre(), xi, choices));
    EXPECT_TRUE(inversion.has_distortion(certified_distortion(inversion, xi)));
    EXPECT_LE(certified_distortion(inversion, xi), xi);
  }
  RandomChoices choices(4, 2, 0);
  EXPECT_EQ(certified_distortion(MapObject(*random_transition(3, choices)), Rational(1)), Rational(0));
  EXPECT_FALSE(random_transition(7, choices).has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
