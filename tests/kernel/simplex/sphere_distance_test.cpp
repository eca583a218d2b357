#include "kernel/simplex/sphere_distance.hpp"

#include "kernel/number/algebraic.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// A triangle inscribed in the circle of radius 5 about the origin of a plane of ℝ³, and a point as vertex 3.
Points over_circle(const Rational& x, const Rational& y, const Rational& z) {
  return {{Rational(5), Rational(0), Rational(0)},
          {Rational(-3), Rational(4), Rational(0)},
          {Rational(-3), Rational(-4), Rational(0)},
          {x, y, z}};
}

TEST(SphereDistance, OfAPointOverTheCircle) {
  // Projection at distance 2 from the centre, height 4: √(4² + 3²) = 5 from the circle.
  const auto offset = *sphere_offset(simplex_of(over_circle(Rational(2), Rational(0), Rational(4))), 3);
  EXPECT_EQ(offset.squared_height, Rational(16));
  EXPECT_EQ(offset.squared_shift, Rational(4));
  EXPECT_EQ(offset.squared_radius, Rational(25));
  EXPECT_EQ(is_circumsphere_within(offset, Rational(25)), Verdict::proved);
  EXPECT_EQ(is_circumsphere_within(offset, Rational(25) - Rational::power_of_two(-300)), Verdict::refuted);
}

TEST(SphereDistance, FromTheDiametricSphere) {
  // |p − C| = 13 outside, 0 inside.
  const auto outside = *sphere_offset(simplex_of(over_circle(Rational(3), Rational(4), Rational(12))), 3);
  EXPECT_EQ(is_diametric_sphere_within(outside, Rational(64)), Verdict::proved);
  EXPECT_EQ(is_diametric_sphere_within(outside, Rational(64) - Rational::power_of_two(-300)), Verdict::refuted);
  const auto centre = *sphere_offset(simplex_of(over_circle(Rational(0), Rational(0), Rational(0))), 3);
  EXPECT_EQ(is_diametric_sphere_within(centre, Rational(25)), Verdict::proved);
  EXPECT_EQ(is_diametric_sphere_within(centre, Rational(25) - Rational::power_of_two(-300)), Verdict::refuted);
  EXPECT_EQ(is_circumsphere_within(centre, Rational(25)), Verdict::proved);
}

TEST(SphereDistance, OfAPointOnTheSphereIsZero) {
  const auto on = *sphere_offset(simplex_of(over_circle(Rational(3), Rational(4), Rational(0))), 3);
  EXPECT_EQ(is_circumsphere_within(on, Rational(0)), Verdict::proved);
  EXPECT_EQ(is_diametric_sphere_within(on, Rational(0)), Verdict::proved);
  // On the diametric sphere, but off the plane of the circumsphere.
  const auto pole = *sphere_offset(simplex_of(over_circle(Rational(0), Rational(0), Rational(5))), 3);
  EXPECT_EQ(is_circumsphere_within(pole, Rational(49)), Verdict::refuted);
  EXPECT_EQ(is_circumsphere_within(pole, Rational(50)), Verdict::proved);
  EXPECT_EQ(is_diametric_sphere_within(pole, Rational(0)), Verdict::proved);
}

TEST(SphereDistance, NeedsAFacetWithACircumcentre) {
  const Points collinear{
      {Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}, {Rational(0), Rational(1)}};
  EXPECT_EQ(sphere_offset(simplex_of(collinear), 3).exists(), Verdict::refuted);
  EXPECT_TRUE(sphere_offset(simplex_of(collinear), 0));
  EXPECT_THROW((void)sphere_offset(simplex_of({{Rational(1)}}), 0), std::invalid_argument);
}

TEST(SphereDistance, OfTheFlatFacetOnACircleIsTheDistanceFromThatCircle) {
  Points flat = over_circle(Rational(3), Rational(4), Rational(0));
  flat.push_back({Rational(5), Rational(0), Rational(7)});
  const auto offset = *sphere_offset(simplex_of(flat), 4);
  EXPECT_EQ(offset.squared_height, Rational(49));
  EXPECT_EQ(is_circumsphere_within(offset, Rational(49)), Verdict::proved);
  EXPECT_EQ(is_circumsphere_within(offset, Rational(48)), Verdict::refuted);
}

// The circumsphere of an edge is the pair of its ends, that of a vertex the vertex.
RC_GTEST_PROP(SphereDistance, FromAnEdgeIsTheDistanceFromItsNearerEnd, ()) {
  const auto m = static_cast<std::size_t>(*rc::gen::inRange(1, 5));
  const auto triangle = simplex_of(*any_points(3, m));
  RC_PRE(triangle.squared_edge(0, 1) > Rational(0));
  const auto offset = *sphere_offset(triangle, 2);
  const Rational nearer = minimum(triangle.squared_edge(2, 0), triangle.squared_edge(2, 1));
  RC_ASSERT(is_circumsphere_within(offset, nearer) == Verdict::proved);
  if (nearer > Rational(0)) {
    RC_ASSERT(is_circumsphere_within(offset, nearer - nearer * Rational::power_of_two(-100)) == Verdict::refuted);
  }
  const auto edge = triangle.face({0, 2});
  RC_ASSERT(is_circumsphere_within(*sphere_offset(edge, 1), edge.squared_edge(0, 1)) == Verdict::proved);
  RC_ASSERT(sphere_offset(edge, 1)->squared_height == edge.squared_edge(0, 1));
}

RC_GTEST_PROP(SphereDistance, CentreDistanceIsThatOfTheCoordinates, ()) {
  const Points points = *any_simplex(1, 6);
  const std::size_t p = static_cast<std::size_t>(*rc::gen::inRange(0, 100)) % points.size();
  Points facet = points;
  facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(p));
  const auto sphere = circumsphere(simplex_of(facet));
  const auto offset = sphere_offset(simplex_of(points), p);
  RC_ASSERT(offset.exists() == sphere.exists());
  if (!offset) return;
  const auto centre = circumcentre(*sphere, facet);
  Rational squared(0);
  for (std::size_t axis = 0; axis < centre.size(); ++axis) squared += square(centre[axis] - points[p][axis]);
  RC_ASSERT(offset->squared_radius == sphere->squared_radius);
  RC_ASSERT(offset->squared_centre_distance() == squared);
  RC_ASSERT(offset->squared_height >= Rational(0));
  if (facet.size() == facet[0].size() + 1 && is_proved(is_zero(offset->squared_height))) {
    RC_ASSERT(offset->squared_shift == squared);
  }
}

RC_GTEST_PROP(SphereDistance, VerdictsSeparateTheEndsOfAnEnclosureOfTheDistance, ()) {
  const Points points = *any_simplex(1, 5);
  const auto exact = sphere_offset(simplex_of(points), 0);
  RC_PRE(exact.has_value());
  const SphereOffset<BigInterval> enclosed{BigInterval(exact->squared_height), BigInterval(exact->squared_shift),
                                           BigInterval(exact->squared_radius)};
  const Rational gap = Rational::power_of_two(-40);
  const BigInterval circumsphere_enclosure = circumsphere_distance(enclosed);
  RC_ASSERT(is_circumsphere_within(*exact, square(circumsphere_enclosure.upper())) == Verdict::proved);
  if (circumsphere_enclosure.lower() > gap) {
    RC_ASSERT(is_circumsphere_within(*exact, square(circumsphere_enclosure.lower() - gap)) == Verdict::refuted);
  }
  const BigInterval diametric_enclosure = diametric_sphere_distance(enclosed);
  RC_ASSERT(is_diametric_sphere_within(*exact, square(diametric_enclosure.upper())) == Verdict::proved);
  if (diametric_enclosure.lower() > gap) {
    RC_ASSERT(is_diametric_sphere_within(*exact, square(diametric_enclosure.lower() - gap)) == Verdict::refuted);
  }
  RC_ASSERT(is_refuted(less(circumsphere_enclosure, diametric_enclosure)) ||
            is_undecided(less(circumsphere_enclosure, diametric_enclosure)));
}

RC_GTEST_PROP(SphereDistance, OnIntervalsNeverContradictsTheExactVerdict, ()) {
  const Points points = *any_simplex(1, 5);
  const Rational bound = square(*any_coordinate() * Rational::power_of_two(-*rc::gen::inRange(0, 12)));
  const auto exact = sphere_offset(simplex_of(points), 0);
  const auto check = [&]<class S>(const EdgeGram<S>& simplex) {
    const auto enclosed = sphere_offset(simplex, 0);
    if (!enclosed) return agrees(enclosed.exists(), exact.exists());
    return exact.has_value() && contains(enclosed->squared_height, exact->squared_height) &&
           contains(enclosed->squared_shift, exact->squared_shift) &&
           contains(enclosed->squared_radius, exact->squared_radius) &&
           agrees(is_circumsphere_within(*enclosed, scalar_from<S>(bound)), is_circumsphere_within(*exact, bound)) &&
           agrees(is_diametric_sphere_within(*enclosed, scalar_from<S>(bound)),
                  is_diametric_sphere_within(*exact, bound));
  };
  RC_ASSERT(check(simplex_on<BigInterval>(points)));
  bool small = false;
  {
    const RoundingGuard guard;
    small = check(simplex_on<Interval>(points));
  }
  RC_ASSERT(small);
}

// The point (2, 0, 1) over the circle of radius 5: (5 − 2)² + 1 = 10.
TEST(SphereDistance, OnAlgebraicNumbersIsTheRootItself) {
  const auto offset = *sphere_offset(
      edge_gram_from_points(points_on<Algebraic>(over_circle(Rational(2), Rational(0), Rational(1)))), 3);
  EXPECT_EQ(is_zero(circumsphere_distance(offset) - square_root(Algebraic(10))), Verdict::proved);
  EXPECT_EQ(is_zero(diametric_sphere_distance(offset) - (Algebraic(5) - square_root(Algebraic(5)))), Verdict::proved);
  const Algebraic bound = Algebraic(5) - square_root(Algebraic(5));
  EXPECT_EQ(is_diametric_sphere_within(offset, square(bound)), Verdict::proved);
  EXPECT_EQ(is_diametric_sphere_within(offset, square(bound) - Algebraic(Rational::power_of_two(-200))),
            Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
