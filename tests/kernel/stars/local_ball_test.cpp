#include "kernel/stars/local_ball.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/exhaustive.hpp"
#include "tests/kernel/stars/curved_patch.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const ModelGeometry unit_torus{Curvature::zero, ratio(1, 2)};

/// The points of a small set, each seen once, from the first.
struct Seen {
  FlatAtlas<2> atlas;
  ChartView<2> view;
  explicit Seen(const ExactPoints<2>& points)
      : atlas(cubic_torus<2>(), PointSet<2>(points), ratio(1, 8)), view(atlas, atlas.net(), unit_torus) {
    view.look(Label(0), 0.4);
  }
};

// A right triangle with legs 3/16 and 4/16: its circle is centred at (3/32, 4/32), radius 5/32.
ExactPoints<2> triangle_and(const Vector<Rational, 2>& other) {
  return {{Rational(0), Rational(0)}, {ratio(3, 16), Rational(0)}, {Rational(0), ratio(4, 16)}, other};
}

LocalBall<2> ball_of(const Vector<Rational, 2>& other) {
  const Seen seen(triangle_and(other));
  EXPECT_EQ(seen.view.size(), 4U);
  return look_at_ball<2>(seen.view, LocalCoordinates::chart, {0, 1, 2}, 1.0 / 16);
}

TEST(LookAtBall, decides_ties_and_what_is_near_them) {
  const Vector<Rational, 2> fourth{ratio(3, 16), ratio(4, 16)};
  const auto tie = ball_of(fourth);
  EXPECT_TRUE(is_refuted(tie.empty));
  EXPECT_EQ(tie.witness, 3U);
  for (const int exponent : {20, 45, 60, 100, 200, 900}) {
    const Rational nudge = Rational::power_of_two(-exponent);
    EXPECT_TRUE(is_proved(ball_of(sum(fourth, Vector<Rational, 2>{nudge, nudge})).empty)) << exponent;
    const auto inside = ball_of(difference(fourth, Vector<Rational, 2>{nudge, nudge}));
    EXPECT_TRUE(is_refuted(inside.empty)) << exponent;
    EXPECT_EQ(inside.witness, 3U);
  }
}

TEST(LookAtBall, encloses_the_ball_and_the_least_power) {
  const Vector<Rational, 2> other{ratio(3, 16) + ratio(1, 100), ratio(1, 4)};
  const auto ball = ball_of(other);
  ASSERT_TRUE(is_proved(ball.empty));
  EXPECT_EQ(ball.nearest, 3U);
  const auto holds = [](const Filter& enclosure, const Rational& exact) {
    return Rational::exactly(enclosure.lower()) <= exact && exact <= Rational::exactly(enclosure.upper()) &&
           enclosure.upper() - enclosure.lower() < 1e-14;
  };
  EXPECT_TRUE(holds(ball.centre[0], ratio(3, 32)));
  EXPECT_TRUE(holds(ball.centre[1], ratio(4, 32)));
  EXPECT_TRUE(holds(ball.squared_radius, ratio(25, 1024)));
  const Rational power = square(other[0] - ratio(3, 32)) + square(ratio(4, 32)) - ratio(25, 1024);
  EXPECT_TRUE(holds(ball.least_power, power / Rational(2)));
}

TEST(LookAtBall, does_not_look_beyond) {
  // The other point is 1/10 outside; nothing is said beyond 1/16.
  const auto ball = ball_of({ratio(-1, 5), ratio(-1, 5)});
  ASSERT_TRUE(is_proved(ball.empty));
  EXPECT_EQ(ball.nearest, 4U) << "nobody";
  EXPECT_NEAR(ball.least_power.lower(), (1.0 / 16) * (1.0 / 16 + 2 * 5.0 / 32) / 2, 1e-12);
}

TEST(LookAtBall, does_not_take_degenerate_simplices) {
  const Seen seen({{Rational(0), Rational(0)}, {ratio(1, 16), ratio(1, 16)}, {ratio(1, 8), ratio(1, 8)}});
  const auto ball = look_at_ball<2>(seen.view, LocalCoordinates::chart, {0, 1, 2}, 1.0 / 16);
  EXPECT_FALSE(is_proved(ball.empty));
  EXPECT_EQ(ball.witness, seen.view.size());
  // One that the filter cannot tell from it, but the next rung can.
  const Seen nearly({{Rational(0), Rational(0)},
                     {ratio(1, 16), ratio(1, 16)},
                     {ratio(1, 8), ratio(1, 8) + Rational::power_of_two(-80)}});
  EXPECT_TRUE(is_proved(look_at_ball<2>(nearly.view, LocalCoordinates::chart, {0, 1, 2}, 1.0 / 16).empty));
}

// Four points of a geodesic circle about p_1 seen from p_0, where their coordinates are not exact.
LocalBall<2> curved_ball(LocalCoordinates coordinates, const Rational& nudge) {
  std::vector<Vector<Rational, 2>> net{{Rational(0), Rational(0)}};
  for (int k = 0; k < 4; ++k) net.push_back({ratio(1, 8), ratio(-1, 9)});
  const CurvedPatch<2> atlas(Curvature::positive, net, ratio(1, 5));
  const ExactPoints<2> points{{Rational(2), Rational(0)},
                              {ratio(3, 10), Rational(0)},
                              {Rational(0), ratio(3, 10)},
                              {ratio(-3, 10), Rational(0)},
                              {ratio(-18, 100) - nudge, ratio(-24, 100)}};
  const PointSet<2> set(points);
  ChartView<2> view(atlas, set, {Curvature::positive, Rational(3)});
  view.look(Label(0), 1);
  return look_at_ball<2>(view, coordinates, {1, 2, 3}, 0.1);
}

TEST(LookAtBall, of_geodesic_circles_is_undecided_at_a_tie_and_decided_beside_it) {
  EXPECT_TRUE(is_undecided(curved_ball(LocalCoordinates::conformal, Rational(0)).empty));
  EXPECT_EQ(curved_ball(LocalCoordinates::conformal, Rational(0)).witness, 4U);
  for (const int exponent : {10, 45, 70, 300, 900}) {
    const Rational nudge = Rational::power_of_two(-exponent);
    EXPECT_TRUE(is_proved(curved_ball(LocalCoordinates::conformal, nudge).empty)) << exponent;
    EXPECT_TRUE(is_refuted(curved_ball(LocalCoordinates::conformal, -nudge).empty)) << exponent;
  }
  // In the chart it is no circle, so no tie either.
  EXPECT_FALSE(is_undecided(curved_ball(LocalCoordinates::chart, Rational(0)).empty));
}

TEST(ThicknessOf, is_the_least_altitude_over_the_longest_edge) {
  const FilterGuard guard;
  const auto metric = FrameMetric<2>::cartesian().on<Filter>();
  const auto at = [](int x, int y) { return Vector<Filter, 2>{Filter(x), Filter(y)}; };
  // Altitude 12/5 on the hypotenuse 5.
  const double thickness = thickness_of<2>(metric, {at(0, 0), at(3, 0), at(0, 4)});
  EXPECT_LE(thickness, 0.24);
  EXPECT_GE(thickness, 0.24 - 1e-14);
  EXPECT_EQ(thickness_of<2>(metric, {at(0, 0), at(1, 1), at(2, 2)}), 0);
}

TEST(ThicknessOf, is_that_of_the_spheres_with_each_vertex_last) {
  const FilterGuard guard;
  const FrameMetric<3> frame({{{ratio(2, 1), ratio(1, 2), ratio(0, 1)},
                               {ratio(1, 2), ratio(1, 1), ratio(1, 4)},
                               {ratio(0, 1), ratio(1, 4), ratio(3, 1)}}});
  for (const auto& metric : {FrameMetric<3>::cartesian().on<Filter>(), frame.on<Filter>()}) {
    const LocalVertices<Filter, 3> vertices{{{Filter(1), Filter(2), Filter(-1)},
                                             {Filter(4), Filter(1), Filter(0)},
                                             {Filter(2), Filter(5), Filter(1)},
                                             {Filter(0), Filter(1), Filter(3)}}};
    Filter longest(0);
    Filter least(100);
    for (std::size_t last = 0; last <= 3; ++last) {
      for (const auto& other : vertices)
        longest = maximum(longest, metric.squared_norm(difference(vertices[last], other)));
      SphereStack<Filter, 3> stack(metric);
      ASSERT_EQ((build_spheres<Filter, 3>(stack, metric, vertices, last)), Verdict::proved);
      least = minimum(least, stack.squared_altitude());
    }
    const Filter expected = square_root(least / longest) / Filter(3);
    const double thickness = thickness_of<3>(metric, vertices);
    EXPECT_LE(thickness, expected.upper());
    EXPECT_GE(thickness, expected.lower() - 1e-14);
  }
}

TEST(BuildSpheres, is_the_same_ball_whichever_vertex_is_last) {
  const auto metric = FrameMetric<2>::cartesian().on<Rational>();
  const LocalVertices<Rational, 2> vertices{
      Vector<Rational, 2>{Rational(0), Rational(0)}, {ratio(3, 16), Rational(0)}, {Rational(0), ratio(4, 16)}};
  for (std::size_t last = 0; last < 3; ++last) {
    SphereStack<Rational, 2> stack(metric);
    ASSERT_TRUE(is_proved(build_spheres<Rational, 2>(stack, metric, vertices, last)));
    EXPECT_EQ(stack.squared_radius(), ratio(25, 1024));
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
