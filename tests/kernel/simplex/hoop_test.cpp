#include "kernel/simplex/hoop.hpp"

#include "kernel/number/algebraic.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Points four_of_a_circle{
    {Rational(5), Rational(0)}, {Rational(3), Rational(4)}, {Rational(-4), Rational(3)}, {Rational(0), Rational(-5)}};

TEST(Hoop, FourPointsOfACircleHaveItForEveryBound) {
  EXPECT_EQ(has_hoop_property(simplex_of(four_of_a_circle), Rational(0)), Verdict::proved);
}

TEST(Hoop, APointOffTheCircleLosesIt) {
  Points moved = four_of_a_circle;
  moved[3][1] -= Rational::power_of_two(-40);
  EXPECT_EQ(has_hoop_property(simplex_of(moved), Rational(0)), Verdict::refuted);
  EXPECT_EQ(has_hoop_property(simplex_of(moved), Rational::power_of_two(-100)), Verdict::refuted);
  EXPECT_EQ(has_hoop_property(simplex_of(moved), Rational::power_of_two(-60)), Verdict::proved);
}

// The right triangle: a leg's end is at distance 1 from the nearer end of the opposite leg (R = 1/2) …
TEST(Hoop, OfARightTriangleHoldsFromTwoOn) {
  EXPECT_EQ(has_hoop_property(simplex_of(right_corner(2)), Rational(4)), Verdict::proved);
  EXPECT_EQ(has_hoop_property(simplex_of(right_corner(2)), Rational(4) - Rational::power_of_two(-300)),
            Verdict::refuted);
}

TEST(Hoop, IsLostWhereAFacetHasNoCircumsphere) {
  const Points collinear{
      {Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}, {Rational(0), Rational(1)}};
  EXPECT_EQ(has_hoop_property(simplex_of(collinear), Rational(1000000)), Verdict::refuted);
}

TEST(Hoop, OfAnEdgeHoldsOnlyIfItsEndsCoincide) {
  EXPECT_EQ(has_hoop_property(simplex_of({{Rational(0)}, {Rational(1)}}), Rational(100)), Verdict::refuted);
  EXPECT_EQ(has_hoop_property(simplex_of({{Rational(1)}, {Rational(1)}}), Rational(0)), Verdict::proved);
}

TEST(Hoop, OnIntervalsIsUndecidedForCocircularPoints) {
  const RoundingGuard guard;
  EXPECT_EQ(has_hoop_property(simplex_on<Interval>(four_of_a_circle), Interval(0)), Verdict::undecided);
}

RC_GTEST_PROP(Hoop, AgreesWithDistancesEnclosedByRoots, ()) {
  const auto simplex = simplex_of(*any_simplex(1, 5));
  const Rational bound = square(*any_coordinate());
  const Verdict exact = has_hoop_property(simplex, bound);
  RC_CLASSIFY(is_proved(exact), "has it");
  Verdict enclosed = Verdict::proved;
  for (std::size_t p = 0; p < simplex.vertex_count(); ++p) {
    const auto offset = sphere_offset(simplex, p);
    if (!offset) {
      enclosed = Verdict::refuted;
      continue;
    }
    const SphereOffset<BigInterval> big{BigInterval(offset->squared_height), BigInterval(offset->squared_shift),
                                        BigInterval(offset->squared_radius)};
    const BigInterval allowed = square_root(BigInterval(bound) * BigInterval(offset->squared_radius));
    enclosed = conjunction(enclosed, less_equal(circumsphere_distance(big), allowed));
  }
  RC_ASSERT(agrees(enclosed, exact));
}

RC_GTEST_PROP(Hoop, OnIntervalsNeverContradictsTheExactVerdict, ()) {
  const Points points = *any_simplex(1, 5);
  const Rational bound = square(*any_coordinate());
  const Verdict exact = has_hoop_property(simplex_of(points), bound);
  RC_ASSERT(agrees(has_hoop_property(simplex_on<BigInterval>(points), BigInterval(bound)), exact));
  const RoundingGuard guard;
  RC_ASSERT(agrees(has_hoop_property(simplex_on<Interval>(points), scalar_from<Interval>(bound)), exact));
}

// Each vertex of the regular triangle is at distance √2 from the ends of an edge with R = √2/2.
TEST(Hoop, OnAlgebraicNumbersIsSharp) {
  const auto triangle = edge_gram_from_points(points_on<Algebraic>(regular_simplex(2)));
  EXPECT_EQ(has_hoop_property(triangle, Algebraic(4)), Verdict::proved);
  EXPECT_EQ(has_hoop_property(triangle, Algebraic(4) - Algebraic(Rational::power_of_two(-200))), Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
