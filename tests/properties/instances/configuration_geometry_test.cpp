#include "properties/instances/configuration_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/simplex/hoop.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational squared_length(const std::vector<Rational>& x) {
  Rational result(0);
  for (const Rational& coordinate : x) result += square(coordinate);
  return result;
}

TEST(ConfigurationGeometry, DirectionsLieOnTheUnitSphereExactlyAndNearWhatWasAsked) {
  for (const std::vector<double>& asked :
       {std::vector<double>{0.6, 0.8}, {-0.6, -0.8}, {0.0, 0.0, -2.0}, {1.0, 1.0, 1.0, -1.0}, {-3.0}}) {
    double length = 0;
    for (const double x : asked) length += x * x;
    const auto direction = rational_direction(asked, 12);
    EXPECT_EQ(squared_length(direction), Rational(1));
    for (std::size_t axis = 0; axis < asked.size(); ++axis) {
      EXPECT_NEAR(approximate_double(direction[axis]), asked[axis] / std::sqrt(length), 0x1p-11);
    }
  }
}

TEST(ConfigurationGeometry, TheDirectionZeroIsTheLastAxis) {
  EXPECT_EQ(rational_direction({0.0, 0.0}, 8), (std::vector<Rational>{0, 1}));
}

TEST(ConfigurationGeometry, ParallelsLieOnTheUnitSphereAtTheirHeight) {
  const Rational q = Rational(1) / Rational(2);
  const auto point = point_of_parallel(q, rational_direction({0.3, 0.4}, 8));
  EXPECT_EQ(squared_length(point), Rational(1));
  EXPECT_EQ(point.back(), Rational(3) / Rational(5));
}

TEST(ConfigurationGeometry, MirroringKeepsLengthsAndUndoesItself) {
  const SimplexObject::Points points{{1, 2, 3}, {-1, 0, 5}};
  const std::vector<Rational> normal{1, -2, 2};
  const auto mirrored = mirrored_points(points, normal);
  EXPECT_NE(mirrored, points);
  EXPECT_EQ(squared_length(mirrored[0]), squared_length(points[0]));
  EXPECT_EQ(squared_length(mirrored[1]), squared_length(points[1]));
  EXPECT_EQ(mirrored_points(mirrored, normal), points);
  EXPECT_EQ(mirrored_points(points, {0, 0, 0}), points);
}

TEST(ConfigurationGeometry, EmbeddingAddsZerosAndScalingMultiplies) {
  EXPECT_EQ(embedded_points({{1, 2}}, 4), (SimplexObject::Points{{1, 2, 0, 0}}));
  EXPECT_EQ(scaled_points({{1, -2}}, Rational(3)), (SimplexObject::Points{{3, -6}}));
}

TEST(ConfigurationGeometry, ShorteningStaysOnItsSideAndClose) {
  const Rational x = Rational(1) / Rational(3);
  EXPECT_LT(shortened_down(x, 10), x);
  EXPECT_GT(shortened_up(x, 10), x);
  EXPECT_LT(shortened_up(x, 10) - shortened_down(x, 10), x * Rational::power_of_two(-8));
  EXPECT_EQ(shortened_down(Rational(0), 10), Rational(0));
  EXPECT_EQ(shortened_up(Rational(3), 10), Rational(3));
}

TEST(ConfigurationGeometry, TheHoopIsTheBoundAtWhichThePropertyBegins) {
  const auto simplex = edge_gram_from_points(SimplexObject::Points{
      {Rational(101) / Rational(100), 0, Rational(1) / Rational(50)}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}});
  const Rational hoop = approximate_hoop(simplex);
  const Rational little = Rational::power_of_two(-20);
  EXPECT_EQ(has_hoop_property(simplex, square(hoop * (Rational(1) + little))), Verdict::proved);
  EXPECT_EQ(has_hoop_property(simplex, square(hoop * (Rational(1) - little))), Verdict::refuted);
}

TEST(ConfigurationGeometry, ADegenerateFacetHasNoHoop) {
  EXPECT_EQ(approximate_hoop(edge_gram_from_points(SimplexObject::Points{{0, 1}, {-1, 0}, {1, 0}, {3, 0}})),
            Rational(0));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
