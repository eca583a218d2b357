#include "kernel/simplex/circumsphere.hpp"

#include "kernel/number/algebraic.hpp"
#include "kernel/simplex/cayley_menger.hpp"
#include "kernel/simplex/realisability.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

Rational squared_distance(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational sum(0);
  for (std::size_t axis = 0; axis < a.size(); ++axis) sum += square(a[axis] - b[axis]);
  return sum;
}

const Points four_of_a_circle{
    {Rational(5), Rational(0)}, {Rational(3), Rational(4)}, {Rational(-4), Rational(3)}, {Rational(0), Rational(-5)}};

TEST(Circumsphere, OfAVertexIsItself) {
  const Points vertex{{Rational(3), ratio(1, 7)}};
  const auto sphere = circumsphere(simplex_of(vertex));
  ASSERT_TRUE(sphere);
  EXPECT_EQ(sphere->squared_radius, Rational(0));
  EXPECT_EQ(circumcentre(*sphere, vertex), vertex[0]);
}

TEST(Circumsphere, OfRegularSimplices) {
  for (std::size_t k = 1; k <= 6; ++k) {
    const auto n = static_cast<long>(k);
    const auto sphere = circumsphere(simplex_of(regular_simplex(k)));
    EXPECT_EQ(sphere->squared_radius, ratio(n, n + 1));
    for (const Rational& coefficient : sphere->barycentric) EXPECT_EQ(coefficient, ratio(1, n + 1));
  }
}

TEST(Circumsphere, OfRightCornersHasTheMiddleOfTheCubeAsItsCentre) {
  for (std::size_t k = 1; k <= 6; ++k) {
    const Points corner = right_corner(k);
    const auto sphere = circumsphere(simplex_of(corner));
    EXPECT_EQ(sphere->squared_radius, ratio(static_cast<long>(k), 4));
    EXPECT_EQ(circumcentre(*sphere, corner), std::vector<Rational>(k, ratio(1, 2)));
  }
}

TEST(Circumsphere, OfPointsOfALineDoesNotExist) {
  const Points collinear{{Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}};
  EXPECT_EQ(circumsphere(simplex_of(collinear)).exists(), Verdict::refuted);
  EXPECT_EQ(squared_circumradius(simplex_of(collinear)).exists(), Verdict::refuted);
}

TEST(Circumsphere, OfFourPointsOfACircleExistsThoughTheTetrahedronIsFlat) {
  const auto sphere = circumsphere(simplex_of(four_of_a_circle));
  ASSERT_TRUE(sphere);
  EXPECT_EQ(sphere->squared_radius, Rational(25));
  EXPECT_EQ(circumcentre(*sphere, four_of_a_circle), (std::vector{Rational(0), Rational(0)}));
  Points moved = four_of_a_circle;
  moved[3][1] -= Rational::power_of_two(-200);
  EXPECT_EQ(circumsphere(simplex_of(moved)).exists(), Verdict::refuted);
}

TEST(Circumsphere, OnIntervalsIsAbsentWhereTheSimplexMayBeDegenerate) {
  Points thin{{Rational(0), Rational(0)}, {ratio(1, 3), ratio(1, 3)}, {ratio(2, 3), ratio(2, 3)}};
  thin[2][1] += Rational::power_of_two(-40);
  ASSERT_TRUE(circumsphere(simplex_of(thin)));
  ASSERT_TRUE(circumsphere(simplex_on<BigInterval>(thin)));
  const RoundingGuard guard;
  EXPECT_EQ(circumsphere(simplex_on<Interval>(thin)).exists(), Verdict::undecided);
}

RC_GTEST_PROP(Circumsphere, CentreHasTheRadiusAsItsDistanceFromEveryVertex, ()) {
  const Points points = *any_simplex(0, 6);
  const auto simplex = simplex_of(points);
  const auto sphere = circumsphere(simplex);
  RC_CLASSIFY(!sphere, "no circumcentre");
  RC_ASSERT(is_proved(sphere.exists()) || is_refuted(is_non_degenerate(simplex)));
  if (!sphere) return;
  Rational total(0);
  for (const Rational& coefficient : sphere->barycentric) total += coefficient;
  RC_ASSERT(total == Rational(1));
  const auto centre = circumcentre(*sphere, points);
  for (const auto& point : points) RC_ASSERT(squared_distance(centre, point) == sphere->squared_radius);
}

RC_GTEST_PROP(Circumsphere, FromEdgeLengthsAloneHasTheSameRadius, ()) {
  const auto simplex = simplex_of(*any_simplex(0, 6));
  const auto by_volumes = squared_circumradius_by_volumes(simplex);
  RC_ASSERT(by_volumes.has_value() == is_proved(is_non_degenerate(simplex)));
  if (by_volumes) RC_ASSERT(*by_volumes == *squared_circumradius(simplex));
}

RC_GTEST_PROP(Circumsphere, RadiusIsAtLeastHalfOfEveryEdgeAndOfEveryFace, ()) {
  const auto simplex = simplex_of(*any_simplex(1, 6));
  const auto radius = squared_circumradius(simplex);
  RC_PRE(radius.has_value());
  for (std::size_t p = 0; p < simplex.vertex_count(); ++p) {
    const auto facet = squared_circumradius(simplex.opposite_facet(p));
    RC_ASSERT(facet.has_value());
    RC_ASSERT(*facet <= *radius);
    for (std::size_t q = 0; q < p; ++q) RC_ASSERT(simplex.squared_edge(p, q) <= Rational(4) * *radius);
  }
}

RC_GTEST_PROP(Circumsphere, OnIntervalsContainsTheExactOne, ()) {
  const Points points = *any_simplex(0, 6);
  const auto exact = circumsphere(simplex_of(points));
  const auto check = [&](const auto& enclosed, const auto& enclosed_points) {
    if (!enclosed) return is_undecided(enclosed.exists()) || enclosed.exists() == exact.exists();
    if (!exact || !contains(enclosed->squared_radius, exact->squared_radius)) return false;
    if (is_refuted(is_non_degenerate(simplex_of(points)))) return true;  // coefficients are not unique
    const auto centre = circumcentre(*exact, points);
    const auto enclosed_centre = circumcentre(*enclosed, enclosed_points);
    for (std::size_t axis = 0; axis < centre.size(); ++axis) {
      if (!contains(enclosed_centre[axis], centre[axis])) return false;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!contains(enclosed->barycentric[i], exact->barycentric[i])) return false;
    }
    return true;
  };
  RC_ASSERT(check(circumsphere(simplex_on<BigInterval>(points)), points_on<BigInterval>(points)));
  bool small = false;
  {
    const RoundingGuard guard;
    small = check(circumsphere(simplex_on<Interval>(points)), points_on<Interval>(points));
  }
  RC_ASSERT(small);
}

/// Vertices of the regular octagon on the unit circle.
std::vector<std::vector<Algebraic>> octagon(std::initializer_list<int> corners) {
  const Algebraic diagonal = square_root(Algebraic(ratio(1, 2)));
  const std::vector<Algebraic> cosines{Algebraic(1),  diagonal,  Algebraic(0), -diagonal,
                                       Algebraic(-1), -diagonal, Algebraic(0), diagonal};
  std::vector<std::vector<Algebraic>> points;
  for (const int corner : corners) {
    points.push_back({cosines[static_cast<std::size_t>(corner)], cosines[static_cast<std::size_t>((corner + 6) % 8)]});
  }
  return points;
}

TEST(Circumsphere, OnAlgebraicNumbersSeesThatFourCornersOfAnOctagonAreCocircular) {
  const auto sphere = circumsphere(edge_gram_from_points(octagon({0, 1, 3, 6})));
  ASSERT_TRUE(sphere);
  EXPECT_EQ(sphere->squared_radius.rational(), Rational(1));
  const auto centre = circumcentre(*sphere, octagon({0, 1, 3, 6}));
  EXPECT_EQ(is_zero(centre[0]), Verdict::proved);
  EXPECT_EQ(is_zero(centre[1]), Verdict::proved);
  auto moved = octagon({0, 1, 3, 6});
  moved[3][1] -= Algebraic(Rational::power_of_two(-200));
  EXPECT_EQ(circumsphere(edge_gram_from_points(moved)).exists(), Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
