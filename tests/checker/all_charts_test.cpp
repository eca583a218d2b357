#include "proofs/checker/core/all_charts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using checker::AllCharts;

constexpr int m = 2;
using Plane = std::array<double, 2>;
using Space = std::array<double, 3>;

double sine(int K, double x) { return K > 0 ? std::sin(x) : std::sinh(x); }
double cosine(int K, double x) { return K > 0 ? std::cos(x) : std::cosh(x); }
double squared_chord(int K, const Space& x, const Space& y) {
  const Space z{x[0] - y[0], x[1] - y[1], x[2] - y[2]};
  return K * z[0] * z[0] + z[1] * z[1] + z[2] * z[2];
}
double squared(const Plane& x) { return x[0] * x[0] + x[1] * x[1]; }
Plane operator-(const Plane& x, const Plane& y) { return {x[0] - y[0], x[1] - y[1]}; }

/// The point at a distance and an angle from the origin, moved along the first axis.
Space point(int K, double distance, double angle, double along) {
  const Space x{cosine(K, distance), sine(K, distance) * std::cos(angle), sine(K, distance) * std::sin(angle)};
  return {cosine(K, along) * x[0] - K * sine(K, along) * x[1], sine(K, along) * x[0] + cosine(K, along) * x[1], x[2]};
}
/// exp^-1 at the origin.
Plane shown(int K, const Space& x) {
  const double length = std::hypot(x[1], x[2]), distance = K > 0 ? std::atan2(length, x[0]) : std::asinh(length);
  return {x[1] / length * distance, x[2] / length * distance};
}

/// A triangle, and a fourth point, in the chart at the origin.
struct Case {
  int K;
  double reach;  // within which all of them and the circumcentre are
  checker::SimplexInSpace simplex;
  double centre, radius, nearest, altitude, longest;  // squares of the last two, as in Bounds
};

/// What holds of a case, by the formulas of the plane.
Case random_case(int K, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Case result{};
  result.K = K;
  const double rho = 0.02 + 0.1 * unit(random), along = 0.3 * unit(random), first = 2 * M_PI * unit(random);
  const Space C = point(K, 0, 0, along);
  std::array<Space, 3> v{};
  for (std::size_t k = 0; k < 3; ++k)
    v[k] = point(K, rho, first + (static_cast<double>(k) + 0.7 * unit(random)) * 2 * M_PI / 3, along);
  const Space q = point(K, rho * (1.05 + unit(random)), 2 * M_PI * unit(random), along);
  result.reach = along + 2.1 * rho;

  const auto up = [](double x) { return x * (1 + 1e-12); };
  const double a = squared_chord(K, v[1], v[2]), b = squared_chord(K, v[0], v[2]), c = squared_chord(K, v[0], v[1]);
  const double dot = (b + c - a) / 2, area = b * c - dot * dot;
  result.simplex.radius = up(squared_chord(K, C, v[0]));
  result.simplex.nearest = squared_chord(K, C, q) / (1 + 1e-12);
  result.simplex.eigenvalue = area / (b + c) / (1 + 1e-12);
  result.simplex.longest = up(std::max({a, b, c}));
  result.simplex.altitude = area / std::max({a, b, c}) / (1 + 1e-12);

  std::array<Plane, 3> y{};
  for (std::size_t k = 0; k < 3; ++k) y[k] = shown(K, v[k]);
  const Plane e = y[1] - y[0], f = y[2] - y[0];
  const double determinant = e[0] * f[1] - e[1] * f[0];
  const Plane centre{y[0][0] + (squared(e) * f[1] - squared(f) * e[1]) / (2 * determinant),
                     y[0][1] + (squared(f) * e[0] - squared(e) * f[0]) / (2 * determinant)};
  result.centre = std::sqrt(squared(centre - shown(K, C)));
  result.radius = std::sqrt(squared(y[0] - centre));
  result.nearest = std::sqrt(squared(shown(K, q) - centre));
  result.longest = std::max({squared(e), squared(f), squared(y[2] - y[1])});
  result.altitude = determinant * determinant / result.longest;
  return result;
}

/// How many of the bounds fail.
int failures(const Case& one, double reach) {
  const checker::Quantity exact(checker::exact_value(std::to_string(static_cast<long>(reach * 1e6) + 1) + "/1000000"));
  const AllCharts::Bounds found = AllCharts(one.K, m, exact).bounds(one.simplex);
  if (!found.known) return 0;
  const double rounded = 1e-11;
  return (one.centre > found.centre + rounded ? 1 : 0) + (one.radius > found.radius + rounded ? 1 : 0) +
         (one.nearest < found.nearest - rounded ? 1 : 0) + (one.altitude < found.altitude - rounded ? 1 : 0) +
         (one.longest > found.longest + rounded ? 1 : 0);
}

class BoundsInAllCharts : public testing::TestWithParam<int> {};

TEST_P(BoundsInAllCharts, hold_of_what_a_chart_shows) {
  std::mt19937_64 random(1);
  int failed = 0, failed_for_less = 0, known = 0;
  for (int number = 0; number < 3000; ++number) {
    const Case one = random_case(GetParam(), random);
    const test::Upwards upwards;
    failed += failures(one, one.reach);
    // The twin: charts that reach farther than it is said.
    failed_for_less += failures(one, one.reach / 4);
    known += AllCharts(one.K, m, checker::Quantity(checker::exact_value("1/3"))).bounds(one.simplex).known ? 1 : 0;
  }
  EXPECT_EQ(failed, 0);
  EXPECT_GT(failed_for_less, 100);
  EXPECT_GT(known, 100);
}

TEST_P(BoundsInAllCharts, are_not_known_of_what_is_flat_or_of_a_reach_that_is_too_wide) {
  std::mt19937_64 random(2);
  Case one = random_case(GetParam(), random);
  const test::Upwards upwards;
  const checker::Quantity third(checker::exact_value("1/3")), wide(checker::Rational(3)),
      thick(checker::exact_value("1/100")), half(checker::exact_value("1/2")), none(checker::Rational(0));
  one.simplex.nearest = 4 * one.simplex.radius;
  const AllCharts charts(one.K, m, third);
  EXPECT_TRUE(charts.bounds(one.simplex).known);
  EXPECT_TRUE(charts.fits(one.simplex, third, thick, none));
  EXPECT_FALSE(charts.fits(one.simplex, none, thick, none));
  EXPECT_FALSE(charts.fits(one.simplex, third, half, none));
  EXPECT_FALSE(charts.fits(one.simplex, third, thick, third));
  EXPECT_FALSE(AllCharts(one.K, m, wide).bounds(one.simplex).known);
  one.simplex.eigenvalue = 0;
  EXPECT_FALSE(charts.bounds(one.simplex).known);
}

INSTANTIATE_TEST_SUITE_P(Curvatures, BoundsInAllCharts, testing::Values(1, -1));

}  // namespace
}  // namespace delcert::checker_tests
