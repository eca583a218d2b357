#include "kernel/simplex/circumscribing_ball.hpp"

#include "kernel/simplex/matrix_norm.hpp"
#include "kernel/simplex/normal_space.hpp"
#include "kernel/simplex/realisability.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational tiny = Rational::power_of_two(-200);

/// The edge from (−1, 0) to (1, 0), R = 1, and the point (x, y) as vertex 2.
SphereOffset<Rational> over_edge(const Rational& x, const Rational& y) {
  return *sphere_offset(simplex_of({{Rational(-1), Rational(0)}, {Rational(1), Rational(0)}, {x, y}}), 2);
}

// The circle through all three points has centre (0, 4/3) and radius 5/3.
TEST(CircumscribingBall, ThroughThePointMustBeSmallerThanTheRadius) {
  const auto offset = over_edge(Rational(0), Rational(3));
  EXPECT_EQ(has_circumscribing_ball_near(offset, 1, ratio(25, 9), Rational(0)), Verdict::refuted);
  EXPECT_EQ(has_circumscribing_ball_near(offset, 1, ratio(25, 9) + tiny, Rational(0)), Verdict::proved);
}

// Radius below 5/4: centre towards (0, 3/4), where the point is at distance 9/4.
TEST(CircumscribingBall, FromOutsideComesAsNearAsTheLargestBallButNotQuite) {
  const auto offset = over_edge(Rational(0), Rational(3));
  EXPECT_EQ(has_circumscribing_ball_near(offset, 1, ratio(25, 16), Rational(1)), Verdict::refuted);
  EXPECT_EQ(has_circumscribing_ball_near(offset, 1, ratio(25, 16), Rational(1) + tiny), Verdict::proved);
  EXPECT_EQ(has_circumscribing_ball_near(offset, 2, ratio(25, 16), Rational(1)), Verdict::refuted);
  EXPECT_EQ(has_circumscribing_ball_near(offset, 2, ratio(25, 16), Rational(1) + tiny), Verdict::proved);
}

// Radius below 13/12: centre towards (0, −5/12), where the point is at distance 11/12.
TEST(CircumscribingBall, FromInsideComesAsNearAsTheLargestBallButNotQuite) {
  const auto offset = over_edge(Rational(0), ratio(1, 2));
  EXPECT_EQ(has_circumscribing_ball_near(offset, 1, ratio(169, 144), ratio(1, 36)), Verdict::refuted);
  EXPECT_EQ(has_circumscribing_ball_near(offset, 1, ratio(169, 144), ratio(1, 36) + tiny), Verdict::proved);
}

// With radius towards 7/2 and centre (0, √45/2), the distance of (3, 0) tends to 9/2.
TEST(CircumscribingBall, OfAPointOnTheLineOfTheEdge) {
  const auto offset = over_edge(Rational(3), Rational(0));
  EXPECT_EQ(has_circumscribing_ball_near(offset, 1, ratio(49, 4), Rational(1)), Verdict::refuted);
  EXPECT_EQ(has_circumscribing_ball_near(offset, 1, ratio(49, 4), Rational(1) + tiny), Verdict::proved);
  // On the line alone there is one ball only; its distance 2 is attained.
  EXPECT_EQ(has_circumscribing_ball_near(offset, 0, ratio(49, 4), Rational(4)), Verdict::proved);
  EXPECT_EQ(has_circumscribing_ball_near(offset, 0, ratio(49, 4), Rational(4) - tiny), Verdict::refuted);
}

TEST(CircumscribingBall, OfAnEndOfTheEdgeIsEveryOne) {
  const auto offset = over_edge(Rational(1), Rational(0));
  EXPECT_EQ(has_circumscribing_ball_near(offset, 1, Rational(1) + tiny, Rational(0)), Verdict::proved);
  EXPECT_EQ(has_circumscribing_ball_near(offset, 1, Rational(1), Rational(0)), Verdict::refuted);
}

TEST(CircumscribingBall, WithAToleranceAboveTheRadiusOnlyOutsideCounts) {
  const auto centre = over_edge(Rational(0), Rational(0));
  EXPECT_EQ(has_circumscribing_ball_near(centre, 1, Rational(1) + tiny, Rational(4)), Verdict::proved);
  EXPECT_EQ(has_circumscribing_ball_near(over_edge(Rational(9), Rational(0)), 1, Rational(1) + tiny, Rational(4)),
            Verdict::refuted);
}

/// Does the ball about C(σ) + n do? Straight from the definition, in coordinates.
bool serves(const std::vector<Rational>& centre, const std::vector<Rational>& on_sphere, const std::vector<Rational>& p,
            const Rational& squared_radius, const Rational& squared_tolerance) {
  Rational own(0);
  Rational other(0);
  for (std::size_t axis = 0; axis < p.size(); ++axis) {
    own += square(on_sphere[axis] - centre[axis]);
    other += square(p[axis] - centre[axis]);
  }
  return own < squared_radius && is_proved(is_at_most_twice_root(own + other - squared_tolerance, own * other));
}

std::vector<Rational> moved(const std::vector<Rational>& from, const Rational& factor,
                            const std::vector<Rational>& by) {
  std::vector<Rational> result;
  for (std::size_t axis = 0; axis < from.size(); ++axis) result.push_back(from[axis] + factor * by[axis]);
  return result;
}

Rational inner(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational sum(0);
  for (std::size_t axis = 0; axis < a.size(); ++axis) sum += a[axis] * b[axis];
  return sum;
}

RC_GTEST_PROP(CircumscribingBall, IsExhibitedWhenProvedAndNotFoundWhenRefuted, ()) {
  const auto k = static_cast<std::size_t>(*rc::gen::inRange(0, 4));
  const std::size_t m = k + static_cast<std::size_t>(*rc::gen::inRange(k == 0 ? 1 : 0, 3));
  Points facet = *any_points(k + 1, m);
  RC_PRE(is_proved(is_non_degenerate(simplex_of(facet))));
  std::vector<Rational> p = *rc::gen::container<std::vector<Rational>>(m, any_coordinate());
  if (*rc::gen::inRange(0, 3) == 0) {  // into the hull of the facet
    p = facet[0];
    for (std::size_t i = 1; i <= k; ++i) {
      const Rational weight = *any_coordinate() / Rational(16);
      for (std::size_t axis = 0; axis < m; ++axis) p[axis] += weight * (facet[i][axis] - facet[0][axis]);
    }
  }
  Points all = facet;
  all.push_back(p);
  const auto offset = *sphere_offset(simplex_of(all), k + 1);
  const Rational growth = ratio(*rc::gen::element(0, 1, 3, 10, 40, 400, 4000), 10);
  const Rational squared_radius = offset.squared_radius * growth + *rc::gen::element(Rational(0), ratio(1, 100));
  const Rational squared_tolerance =
      square(*rc::gen::element(Rational(0), ratio(1, 1000), ratio(1, 7), Rational(1), Rational(9), Rational(200)));

  const auto space = *normal_space(facet);
  RC_ASSERT(space.directions.size() == m - k);
  // The height vector: p − C(σ) projected to the directions.
  const auto to_p = moved(p, Rational(-1), space.base);
  std::vector<Rational> shadow;
  for (const auto& direction : space.directions) shadow.push_back(inner(direction, to_p));
  const auto coefficients = GramElimination<Rational>(gram_of_columns<Rational>(space.directions)).solve(shadow)->x;
  std::vector<Rational> height(m);
  for (std::size_t i = 0; i < coefficients.size(); ++i) height = moved(height, coefficients[i], space.directions[i]);
  RC_ASSERT(inner(height, height) == offset.squared_height);

  std::vector<std::vector<Rational>> centres{space.base};
  const Rational reach = squared_radius - offset.squared_radius;
  const auto try_along = [&](const std::vector<Rational>& direction) {
    const Rational length = inner(direction, direction);
    if (length == Rational(0) || reach <= Rational(0)) return;
    const Rational farthest = square_root_lower(reach / length, 80) * (Rational(1) - Rational::power_of_two(-70));
    for (const int part : {-4, -3, -2, -1, 1, 2, 3, 4}) {
      centres.push_back(moved(space.base, farthest * ratio(part, 4), direction));
    }
    const Rational slope = Rational(2) * inner(direction, to_p);
    if (slope != Rational(0)) {
      centres.push_back(
          moved(space.base, (offset.squared_centre_distance() - offset.squared_radius) / slope, direction));
    }
  };
  try_along(height);
  for (const auto& direction : space.directions) try_along(direction);
  bool found = false;
  for (const auto& centre : centres) {
    found = found || serves(centre, facet[0], p, squared_radius, squared_tolerance);
  }
  const Verdict verdict = has_circumscribing_ball_near(offset, m - k, squared_radius, squared_tolerance);
  RC_CLASSIFY(is_proved(verdict), "exists");
  RC_CLASSIFY(is_refuted(verdict) && reach > Rational(0), "does not exist, with room for balls");
  RC_ASSERT(verdict == verdict_of(found));
}

RC_GTEST_PROP(CircumscribingBall, OnIntervalsNeverContradictsTheExactVerdict, ()) {
  const Points points = *any_simplex(1, 4);
  const std::size_t normal_dimension = points[0].size() + 2 - points.size();
  const auto exact = sphere_offset(simplex_of(points), 0);
  RC_PRE(exact.has_value());
  const Rational squared_radius = exact->squared_radius + square(*any_coordinate());
  const Rational squared_tolerance = square(*any_coordinate());
  const Verdict verdict = has_circumscribing_ball_near(*exact, normal_dimension, squared_radius, squared_tolerance);
  const auto check = [&]<class S>(const EdgeGram<S>& simplex) {
    const auto offset = sphere_offset(simplex, 0);
    return !offset || agrees(has_circumscribing_ball_near(*offset, normal_dimension, scalar_from<S>(squared_radius),
                                                          scalar_from<S>(squared_tolerance)),
                             verdict);
  };
  RC_ASSERT(check(simplex_on<BigInterval>(points)));
  const RoundingGuard guard;
  RC_ASSERT(check(simplex_on<Interval>(points)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
