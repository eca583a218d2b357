#include "properties/instances/space_star.hpp"

#include <gtest/gtest.h>

#include "tests/properties/instances/square_net.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The square lattice at this scale, sheared.
SpaceObject nearly_square(Curvature curvature, const Rational& scale, const Rational& shift) {
  auto points = square_points(6);
  for (auto& point : points) {
    point[0] += point[1] * shift;
    for (Rational& coordinate : point) coordinate *= scale;
  }
  return {curvature, Rational(3), std::move(points)};
}

const ExactPoint origin{Rational(0), Rational(0)};

TEST(SpaceStar, IsThatOfThePlaneWhereTheScaleIsSmall) {
  for (const Curvature curvature : {Curvature::negative, Curvature::positive}) {
    const SpaceObject space = nearly_square(curvature, ratio(1, 1000), ratio(1, 10));
    const NetObject flat(space.points(), Rational(1), Rational(0));
    const auto expected = star_cells<2>(flat.vectors<2>(), ratio(1, 300));
    ASSERT_TRUE(expected.has_value());
    const auto in_space = star_in_space(space);
    ASSERT_TRUE(in_space.has_value());
    EXPECT_EQ(*in_space, *expected);
    for (const ExactPoint& centre : {origin, space.points()[20], space.points()[100]}) {
      const auto in_chart = star_in_chart(space, centre);
      ASSERT_TRUE(in_chart.has_value());
      EXPECT_EQ(in_chart->cells, *expected);
    }
  }
}

TEST(SpaceStar, MeasuresAreThoseOfThePlaneUpToCurvature) {
  // The triangle 0, (1, 0), (1/10, 1) has the altitude 1/√1.81 on its edge of length √1.81.
  const auto star = star_in_chart(nearly_square(Curvature::negative, ratio(1, 1024), ratio(1, 10)), origin);
  ASSERT_TRUE(star.has_value());
  const BigInterval thickness = star->thickness * BigInterval(2);
  EXPECT_TRUE(is_proved(less(thickness, BigInterval(ratio(5530, 10000)))));  // 1/1.81 = 0.5525
  EXPECT_TRUE(is_proved(less(BigInterval(ratio(5520, 10000)), thickness)));
  // In units of the lattice, and 3 the unit of the space: 0.1346 for the fourth corner of a cell.
  const BigInterval protection = star->protection * BigInterval(1024) / BigInterval(3);
  EXPECT_TRUE(is_proved(less(protection, BigInterval(ratio(140, 1000)))));
  EXPECT_TRUE(is_proved(less(BigInterval(ratio(130, 1000)), protection)));
}

TEST(SpaceStar, CurvatureDecidesWhatIsCocircularInThePlane) {
  for (const Curvature curvature : {Curvature::negative, Curvature::positive}) {
    const SpaceObject space = nearly_square(curvature, ratio(1, 16), Rational(0));
    const auto in_space = star_in_space(space);
    ASSERT_TRUE(in_space.has_value());
    // Four squares of cocircular points: circles are circles in conformal coordinates.
    EXPECT_EQ(in_space->size(), 4U);
    for (const auto& cell : *in_space) EXPECT_EQ(cell.size(), 4U);
    // In the chart at the origin they are not: the fourth corner is nearer on the sphere, so that its diagonal is
    // there.
    const auto in_chart = star_in_chart(space, origin);
    ASSERT_TRUE(in_chart.has_value());
    EXPECT_EQ(in_chart->cells.size(), curvature == Curvature::positive ? 8U : 4U);
    EXPECT_NE(in_chart->cells, *in_space);
    EXPECT_TRUE(is_proved(less(BigInterval(0), in_chart->protection)));
  }
}

TEST(SpaceStar, NothingIsSaidAtTheBoundaryOrFarOut) {
  auto points = nearly_square(Curvature::positive, ratio(1, 100), ratio(1, 10)).points();
  std::swap(points[0], points[1]);  // a corner of the square is first
  const SpaceObject corner(Curvature::positive, Rational(1), points);
  EXPECT_FALSE(star_in_chart(corner, origin).has_value());
  EXPECT_FALSE(star_in_space(corner).has_value());
  const SpaceObject large = nearly_square(Curvature::positive, ratio(1, 5), ratio(1, 10));
  EXPECT_FALSE(star_in_chart(large, origin).has_value());
  EXPECT_FALSE(star_in_space(large).has_value());
  const SpaceObject space = nearly_square(Curvature::positive, ratio(1, 100), ratio(1, 10));
  EXPECT_FALSE(star_in_chart(space, {Rational(1), ratio(1, 2)}).has_value());
}

TEST(SpaceStar, CocircularPointsInAChartAreLeftOpen) {
  // So small that 128 bits do not tell the chart from the plane.
  const SpaceObject space = nearly_square(Curvature::positive, Rational::power_of_two(-200), Rational(0));
  EXPECT_FALSE(star_in_chart(space, origin).has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
