#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(ZeroSetEvaluation, encloses_heights_of_the_sphere) {
  const RoundingGuard guard;
  const ZeroSet sphere = unit_sphere_in_space();
  const TangentChart chart = polar_chart(ratio(1, 2), ratio(1, 4));
  const auto evaluation = sphere.evaluation();
  const std::array<Interval, 2> y{Interval::exactly(0.375), Interval::exactly(0)};
  const auto z = evaluation->heights(chart, y.data());
  ASSERT_TRUE(z);
  EXPECT_LE((*z)[0].lower(), std::sqrt(1 - 0.375 * 0.375) - 1 + 1e-15);
  EXPECT_GE((*z)[0].upper(), std::sqrt(1 - 0.375 * 0.375) - 1 - 1e-15);
  EXPECT_LT((*z)[0].upper() - (*z)[0].lower(), 1e-12);
  const std::array<Rational, 2> exact{ratio(3, 8), Rational(0)};
  EXPECT_FALSE(evaluation->heights(chart, exact.data()));
  const std::array<Interval, 2> outside{Interval::exactly(1.5), Interval::exactly(0)};
  EXPECT_FALSE(evaluation->heights(chart, outside.data()));
}

TEST(ZeroSetEvaluation, encloses_the_derivative_and_the_value_about_a_simplex) {
  const RoundingGuard guard;
  const ZeroSet sphere = unit_sphere_in_space();
  const TangentChart chart = polar_chart(ratio(1, 2), ratio(1, 4));
  const std::array<std::array<double, 3>, 3> corners{{{0, 0, 1}, {0.28, 0, 0.96}, {0, 0.28, 0.96}}};
  std::array<std::array<Interval, 3>, 3> places;
  std::array<const Interval*, 3> vertices;
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) places[v][axis] = Interval::exactly(corners[v][axis]);
    vertices[v] = places[v].data();
  }
  DerivativeHull hull;
  ASSERT_TRUE(sphere.evaluation()->enclose(chart, vertices, 0.03, hull));
  // Df = 2x, so that the hull is that of the vertices, and what is within twice the displacement.
  ASSERT_EQ(hull.matrices.size(), 3U);
  EXPECT_GE(hull.spread.lower(), 0.06);
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_LE(hull.matrices[v][axis].lower(), 2 * corners[v][axis]);
      EXPECT_GE(hull.matrices[v][axis].upper(), 2 * corners[v][axis]);
      EXPECT_LT(hull.matrices[v][axis].upper() - hull.matrices[v][axis].lower(), 1e-12);
    }
  }
  // |f| at the middle of the longest edge is a quarter of its square.
  EXPECT_GE(hull.height, 0.28 * 0.28 / 2);
  EXPECT_LE(hull.height, 0.28 * 0.28 / 2 * 1.4);
  const ZeroSet pole = zero_set("pole", {"x", "y", "z"}, {"x/(z - 1) + y"}, {Rational(2), Rational(2), Rational(2)});
  EXPECT_FALSE(pole.evaluation()->enclose(chart, vertices, 0.03, hull));
}

TEST(ZeroSetEvaluation, bounds_the_second_derivative_of_the_heights) {
  const RoundingGuard guard;
  const ZeroSet sphere = unit_sphere_in_space();
  const TangentChart chart = polar_chart(ratio(1, 2), ratio(1, 4));
  const Interval side = Interval::between(-0.01, 0.01);
  std::array<Interval, 3> place{side, side, side};
  const auto change = sphere.evaluation()->slope_change(chart, place.data(), Interval::exactly(0.01));
  ASSERT_TRUE(change);
  // The identity, by Frobenius.
  EXPECT_GE(change->rate.upper(), std::sqrt(2.0));
  EXPECT_LE(change->rate.upper(), 1.6);
  EXPECT_EQ(change->size.upper(), 0);
  place[2] = Interval::between(-1, 1);
  EXPECT_FALSE(sphere.evaluation()->slope_change(chart, place.data(), Interval::exactly(0.01)));
}

TEST(ZeroSetEvaluation, samples_points_with_normals) {
  const ZeroSet torus = torus_of_revolution();
  const auto sampler = torus.sampler(0.1);
  CounterRandom random(1, RandomPurpose::darts, 0, 0);
  std::size_t found = 0;
  for (int dart = 0; dart < 50; ++dart) {
    std::vector<double> x = sampler->dart(random);
    if (!sampler->project(x, nullptr)) continue;
    ++found;
    const double from_circle = std::hypot(std::hypot(x[0], x[1]) - 2, x[2]);
    EXPECT_NEAR(from_circle, 1, 1e-9);
    const auto normals = sampler->normals(x);
    ASSERT_TRUE(normals);
    const double across = 1 - 2 / std::hypot(x[0], x[1]);
    const std::array<double, 3> outwards{across * x[0], across * x[1], x[2]};
    const double length = std::hypot((*normals)[0], (*normals)[1], (*normals)[2]);
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR((*normals)[axis] / length, outwards[axis], 1e-6);
  }
  EXPECT_GE(found, 40U);
  const ZeroSet pole = zero_set("pole", {"x", "y", "z"}, {"x/(z - 1) + y"}, {Rational(2), Rational(2), Rational(2)});
  EXPECT_FALSE(pole.sampler(0.1)->normals({0, 0, 1}));
}

TEST(ZeroSetSampler, knows_how_the_zero_set_bends) {
  const auto curvature = [](const ZeroSet& m, const std::vector<double>& x) { return m.sampler(1)->curvature(x); };
  EXPECT_NEAR(curvature(unit_sphere_in_space(), {0, 0.6, 0.8}), 1, 1e-6);
  // Principal curvatures 1 and 1/3 outside, 1 and −1 inside.
  EXPECT_NEAR(curvature(torus_of_revolution(), {3, 0, 0}), 1, 1e-6);
  EXPECT_NEAR(curvature(torus_of_revolution(), {0.6, 0.8, 0}), 1, 1e-6);
  // |II(e, e)| is 1 for both circles, and less between them: an upper bound.
  const double found = curvature(clifford_torus(), {1, 0, 0.6, 0.8});
  EXPECT_GE(found, 1 - 1e-6);
  EXPECT_LE(found, 1.5);
  EXPECT_EQ(curvature(cone(), {0, 0, 0}), std::numeric_limits<double>::infinity());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
