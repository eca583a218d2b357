#include "properties/instances/curved_net_bounds.hpp"

#include <gtest/gtest.h>

#include "properties/instances/space_vocabulary.hpp"
#include "tests/properties/instances/square_net.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

SpaceObject square_net(Curvature curvature, const Rational& shift) {
  auto points = square_points(3);
  for (auto& point : points) {
    point[1] += shift;
    for (Rational& coordinate : point) coordinate *= ratio(1, 16);
  }
  return {curvature, Rational(5), std::move(points)};
}

CurvedNetBounds bounds_of(const SpaceObject& p, const SpaceObject& q, std::size_t j, const Rational& epsilon,
                          const Rational& radius_i, const Rational& radius_j) {
  return curved_net_bounds(p, q, j, epsilon, radius_i, radius_j, squared_separation_in_coordinates(p));
}

constexpr std::array curvatures{Curvature::negative, Curvature::positive};

/// The bounds hold for all pairs of points, and come near to what some pairs need.
TEST(CurvedNetBounds, HoldForAllPairsOfPoints) {
  constexpr std::size_t j = 10;
  for (const Curvature curvature : curvatures) {
    const SpaceObject p = square_net(curvature, Rational(0));
    const SpaceObject q = square_net(curvature, ratio(1, 8));
    const Rational epsilon = ratio(5, 36);
    const CurvedNetBounds bounds = bounds_of(p, q, j, epsilon, epsilon, epsilon);
    const BigInterval ball(Rational(6) * epsilon);
    BigInterval nearest(100);
    BigInterval greatest(0);
    BigInterval greatest_of_metric(0);
    BigInterval farthest(0);
    for (std::size_t a = 0; a < p.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const BigInterval in_i = *distance_in_chart<BigInterval>(p, 0, a, b);
        const BigInterval in_j = *distance_in_chart<BigInterval>(p, j, a, b);
        nearest = minimum(nearest, minimum(in_i, in_j));
        if (!is_proved(less(*distance_in_space<BigInterval>(p, 0, a), ball)) ||
            !is_proved(less(*distance_in_space<BigInterval>(p, 0, b), ball))) {
          continue;
        }
        greatest = maximum(greatest, absolute(in_i - in_j) / in_i);
        greatest_of_metric =
            maximum(greatest_of_metric, absolute(in_i - *distance_in_space<BigInterval>(p, a, b)) / in_i);
      }
      const SpaceObject moved(curvature, p.unit(), {p.points()[0], p.points()[j], p.points()[a], q.points()[a]});
      for (const std::size_t centre : {0U, 1U}) {
        farthest = maximum(farthest, *distance_in_chart<BigInterval>(moved, centre, 2, 3));
      }
    }
    EXPECT_TRUE(is_proved(less(BigInterval(bounds.separation), nearest)));
    EXPECT_TRUE(is_proved(less(nearest, BigInterval(bounds.separation * ratio(6, 5)))));
    EXPECT_TRUE(is_proved(less(greatest, BigInterval(bounds.distortion))));
    EXPECT_TRUE(is_proved(less(BigInterval(bounds.distortion / Rational(4)), greatest)));
    EXPECT_TRUE(is_proved(less(greatest_of_metric, BigInterval(bounds.metric_distortion))));
    EXPECT_TRUE(is_proved(less(BigInterval(bounds.metric_distortion / Rational(4)), greatest_of_metric)));
    EXPECT_TRUE(is_proved(less(farthest, BigInterval(bounds.displacement))));
    EXPECT_TRUE(is_proved(less(BigInterval(bounds.displacement * ratio(4, 5)), farthest)));
  }
}

TEST(CurvedNetBounds, RadiiGrowOnSpheresOnlyAndRoomIsLimited) {
  const Rational epsilon = ratio(5, 36);
  for (const Curvature curvature : curvatures) {
    const SpaceObject p = square_net(curvature, Rational(0));
    constexpr std::size_t neighbour = 18;
    const CurvedNetBounds bounds = bounds_of(p, p, neighbour, epsilon, epsilon, epsilon);
    EXPECT_TRUE(bounds.has_room);
    EXPECT_EQ(radius_in_chart(p, epsilon, epsilon) > epsilon, curvature == Curvature::positive);
    EXPECT_EQ(bounds.displacement, Rational(0));
    EXPECT_FALSE(bounds_of(p, p, neighbour, epsilon, epsilon * Rational(2), epsilon).has_room);
    EXPECT_FALSE(bounds_of(p, p, neighbour, epsilon, epsilon, epsilon * Rational(2)).has_room);
  }
}

TEST(CurvedNetBounds, SeparationsOfCoordinatesAreExact) {
  EXPECT_EQ(squared_separation_in_coordinates(square_net(Curvature::negative, Rational(0))), ratio(1, 256));
}

TEST(CurvedNetBounds, CoveringsAndBallsInTheSpaceAreThoseOfCoordinatesFromAbove) {
  const SpaceObject sphere = square_net(Curvature::positive, Rational(0));
  const SpaceObject hyperbolic = square_net(Curvature::negative, Rational(0));
  EXPECT_EQ(covering_in_space(sphere, ratio(1, 32), Rational(1)), ratio(5, 32));
  EXPECT_EQ(covering_in_space(hyperbolic, ratio(1, 2), ratio(1, 2)), ratio(10, 3));
  // 2 tan(1/2) and 2 tanh(1/2).
  EXPECT_GT(ball_in_coordinates(sphere, Rational(5)), ratio(10926, 10000));
  EXPECT_LT(ball_in_coordinates(sphere, Rational(5)), ratio(10927, 10000));
  EXPECT_GT(ball_in_coordinates(hyperbolic, Rational(5)), ratio(9242, 10000));
  EXPECT_LT(ball_in_coordinates(hyperbolic, Rational(5)), ratio(9243, 10000));
}

TEST(CurvedNetBounds, TheRegionOfInterestIsTheOpenBall) {
  const SpaceObject sphere = square_net(Curvature::positive, Rational(0));
  // The neighbours are at 10 arctan(1/32) = 0.3124, the corners at 0.4416.
  EXPECT_EQ(points_within(sphere, ratio(312, 1000))->size(), 1U);
  EXPECT_EQ(points_within(sphere, ratio(313, 1000))->size(), 5U);
  EXPECT_EQ(points_within(sphere, ratio(442, 1000))->size(), 9U);
  EXPECT_FALSE(points_within(square_net(Curvature::positive, Rational(1)), ratio(1, 100)).has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
