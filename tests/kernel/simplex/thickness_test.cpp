#include "kernel/simplex/thickness.hpp"

#include "kernel/number/algebraic.hpp"
#include "kernel/simplex/cayley_menger.hpp"
#include "kernel/simplex/faces.hpp"
#include "kernel/simplex/realisability.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The triangle with base 1 and height 2⁻ᵉ over the middle of the base: its thickness is 2^−(e+1).
Points thin_triangle(long e) {
  return {{Rational(0), Rational(0)}, {Rational(1), Rational(0)}, {ratio(1, 2), Rational::power_of_two(-e)}};
}

TEST(Thickness, OfAVertexAndOfAnEdgeIsOne) {
  EXPECT_EQ(*squared_thickness(simplex_of({{Rational(5)}})), Rational(1));
  EXPECT_EQ(*squared_thickness(simplex_of({{Rational(5)}, {ratio(1, 3)}})), Rational(1));
  const RoundingGuard guard;
  const auto edge = squared_thickness(simplex_on<Interval>({{Rational(5)}, {ratio(1, 3)}}));
  EXPECT_EQ(edge->lower(), 1);
  EXPECT_EQ(edge->upper(), 1);
}

TEST(Thickness, OfRegularSimplices) {
  for (std::size_t k = 1; k <= 6; ++k) {
    const auto n = static_cast<long>(k);
    EXPECT_EQ(*squared_thickness(simplex_of(regular_simplex(k))), ratio(n + 1, 2 * n * n * n));
  }
}

TEST(Thickness, OfRightCorners) {
  for (std::size_t k = 2; k <= 6; ++k) {
    const auto n = static_cast<long>(k);
    EXPECT_EQ(*squared_thickness(simplex_of(right_corner(k))), ratio(1, 2 * n * n * n));
  }
}

TEST(Thickness, OfDegenerateSimplicesIsZero) {
  const Points collinear{{Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}};
  EXPECT_EQ(*squared_thickness(simplex_of(collinear)), Rational(0));
  EXPECT_EQ(*squared_thickness(simplex_of({{Rational(2)}, {Rational(2)}})), Rational(0));
  EXPECT_EQ(*squared_thickness(simplex_of({{Rational(2)}, {Rational(2)}, {Rational(2)}})), Rational(0));
  EXPECT_EQ(is_thickness_at_least(simplex_of({{Rational(2)}, {Rational(2)}}), ratio(1, 100)), Verdict::refuted);
}

TEST(Thickness, IsDecidedDownToTwoToTheMinusHundred) {
  const long e = 99;
  const auto simplex = simplex_of(thin_triangle(e));
  const Rational exact = Rational::power_of_two(-2 * (e + 1));
  EXPECT_EQ(*squared_thickness(simplex), exact);
  EXPECT_EQ(is_thickness_at_least(simplex, exact), Verdict::proved);
  EXPECT_EQ(is_thickness_at_least(simplex, exact + Rational::power_of_two(-400)), Verdict::refuted);
}

TEST(Thickness, OnIntervalsOfAFlatTriangleIsNeverAWrongNumber) {
  Points nearly_flat = thin_triangle(99);
  for (auto& point : nearly_flat) {
    for (auto& coordinate : point) coordinate = coordinate / Rational(3);
  }
  const RoundingGuard guard;
  const auto enclosed = squared_thickness(simplex_on<Interval>(nearly_flat));
  ASSERT_TRUE(enclosed);  // all edges are certain
  EXPECT_LE(enclosed->lower(), 0);
  EXPECT_GT(enclosed->upper(), 0);
  EXPECT_EQ(is_thickness_at_least(simplex_on<Interval>(nearly_flat), scalar_from<Interval>(ratio(1, 4))),
            Verdict::refuted);
  EXPECT_EQ(
      is_thickness_at_least(simplex_on<Interval>(nearly_flat), scalar_from<Interval>(Rational::power_of_two(-200))),
      Verdict::undecided);
}

TEST(Thickness, OnIntervalsOneShortAltitudeRefutesBesideUnknownOnes) {
  const Points flat{{Rational(0), Rational(1), Rational(0)},
                    {Rational(0), Rational(0), Rational(0)},
                    {ratio(1, 3), ratio(1, 3), ratio(1, 3)},
                    {ratio(2, 3), ratio(2, 3), ratio(2, 3)}};
  const RoundingGuard guard;
  EXPECT_EQ(squared_thickness(simplex_on<Interval>(flat)).exists(), Verdict::undecided);
  EXPECT_EQ(is_thickness_at_least(simplex_on<Interval>(flat), scalar_from<Interval>(ratio(1, 100))), Verdict::refuted);
}

RC_GTEST_PROP(Thickness, IsTheLeastAltitudeOverDimensionTimesLongestEdge, ()) {
  const auto simplex = simplex_of(*any_simplex(2, 6));
  const auto k = static_cast<long>(simplex.dimension());
  const bool degenerate = cayley_menger_determinant(simplex) == Rational(0);
  const Rational thickness_squared = *squared_thickness(simplex);
  RC_ASSERT((thickness_squared == Rational(0)) == degenerate);
  if (degenerate) return;
  for (std::size_t p = 0; p < simplex.vertex_count(); ++p) {
    RC_ASSERT(*squared_altitude_by_volumes(simplex, p) >=
              thickness_squared * Rational(k * k) * squared_longest_edge(simplex));
  }
  RC_ASSERT(is_thickness_at_least(simplex, thickness_squared) == Verdict::proved);
  RC_ASSERT(is_thickness_at_least(simplex, thickness_squared + Rational::power_of_two(-500)) == Verdict::refuted);
}

RC_GTEST_PROP(Thickness, FacesOfThickSimplicesAreThick, ()) {
  const auto simplex = simplex_of(*any_simplex(1, 5));
  for (std::size_t size = 1; size <= simplex.dimension(); ++size) {
    for (Faces faces(simplex.vertex_count(), size); faces.has_face(); faces.advance()) {
      RC_ASSERT(*squared_thickness(simplex.face(faces.vertices())) >= *squared_thickness(simplex));
    }
  }
}

RC_GTEST_PROP(Thickness, DoesNotDependOnScale, ()) {
  const Points points = *any_simplex(0, 5);
  const Rational factor = ratio(*rc::gen::inRange(1, 50), *rc::gen::inRange(1, 50));
  Points scaled_points = points;
  for (auto& point : scaled_points) {
    for (auto& coordinate : point) coordinate *= factor;
  }
  RC_ASSERT(*squared_thickness(simplex_of(points)) == *squared_thickness(simplex_of(scaled_points)));
}

RC_GTEST_PROP(Thickness, OnIntervalsContainsTheExactValueAndNeverContradictsIt, ()) {
  const Points points = *any_simplex(0, 5);
  const Rational exact = *squared_thickness(simplex_of(points));
  const Rational bound = *rc::gen::element(exact, exact + ratio(1, 1000000), ratio(1, 16), ratio(1, 1024));
  RC_PRE(bound > Rational(0));
  const Verdict verdict = is_thickness_at_least(simplex_of(points), bound);
  RC_ASSERT(verdict == verdict_of(exact >= bound));
  const auto big = simplex_on<BigInterval>(points);
  if (const auto enclosed = squared_thickness(big)) RC_ASSERT(contains(*enclosed, exact));
  RC_ASSERT(agrees(is_thickness_at_least(big, BigInterval(bound)), verdict));
  const RoundingGuard guard;
  const auto small = simplex_on<Interval>(points);
  if (const auto enclosed = squared_thickness(small)) {
    RC_ASSERT(contains(*enclosed, exact));
    RC_ASSERT(contains(square(*thickness(small)), exact));
  }
  RC_ASSERT(agrees(is_thickness_at_least(small, scalar_from<Interval>(bound)), verdict));
}

/// The regular triangle of side 1 in the plane, which needs √3.
std::vector<std::vector<Algebraic>> regular_triangle() {
  const Algebraic half(ratio(1, 2));
  return {{Algebraic(0), Algebraic(0)}, {Algebraic(1), Algebraic(0)}, {half, square_root(Algebraic(3)) * half}};
}

TEST(Thickness, OnAlgebraicNumbersIsExact) {
  const auto simplex = edge_gram_from_points(regular_triangle());
  EXPECT_EQ(squared_thickness(simplex)->rational(), ratio(3, 16));
  const Algebraic exact = square_root(Algebraic(3)) / Algebraic(4);
  EXPECT_EQ(is_zero(*thickness(simplex) - exact), Verdict::proved);
  EXPECT_EQ(is_thickness_at_least(simplex, square(exact)), Verdict::proved);
  EXPECT_EQ(is_thickness_at_least(simplex, Algebraic(ratio(3, 16) + Rational::power_of_two(-300))), Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
