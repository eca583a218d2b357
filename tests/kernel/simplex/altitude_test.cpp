#include "kernel/simplex/altitude.hpp"

#include "kernel/simplex/cayley_menger.hpp"
#include "kernel/simplex/realisability.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(Altitude, OfRegularSimplices) {
  for (std::size_t k = 1; k <= 6; ++k) {
    const auto simplex = simplex_of(regular_simplex(k));
    const auto n = static_cast<long>(k);
    for (std::size_t p = 0; p <= k; ++p) EXPECT_EQ(*squared_altitude(simplex, p), ratio(n + 1, n));
  }
}

TEST(Altitude, OfRightCorners) {
  for (std::size_t k = 1; k <= 6; ++k) {
    const auto simplex = simplex_of(right_corner(k));
    EXPECT_EQ(*squared_altitude(simplex, 0), ratio(1, static_cast<long>(k)));
    for (std::size_t p = 1; p <= k; ++p) EXPECT_EQ(*squared_altitude(simplex, p), Rational(1));
  }
}

TEST(Altitude, ExistsForDegenerateSimplices) {
  const Points collinear{{Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}};
  for (std::size_t p = 0; p < 3; ++p) EXPECT_EQ(*squared_altitude(simplex_of(collinear), p), Rational(0));
  // Two vertices coincide: the third is at distance 5 from the hull {q} of its opposite facet.
  const Points doubled{{Rational(3), Rational(4)}, {Rational(0), Rational(0)}, {Rational(0), Rational(0)}};
  EXPECT_EQ(*squared_altitude(simplex_of(doubled), 0), Rational(25));
  EXPECT_EQ(*squared_altitude(simplex_of(doubled), 1), Rational(0));
}

TEST(Altitude, OfAVertexIsRefused) {
  EXPECT_THROW((void)squared_altitude(simplex_of({{Rational(1)}}), 0), std::invalid_argument);
}

TEST(Altitude, OnIntervalsIsAbsentWhereTheFacetMayBeDegenerate) {
  const Points thin{{Rational(0), Rational(1), Rational(0)},
                    {Rational(0), Rational(0), Rational(0)},
                    {ratio(1, 3), ratio(1, 3), ratio(1, 3)},
                    {ratio(2, 3), ratio(2, 3), ratio(2, 3)}};
  const RoundingGuard guard;
  EXPECT_EQ(squared_altitude(simplex_on<Interval>(thin), 0).exists(), Verdict::undecided);
  EXPECT_EQ(squared_dual_lengths(simplex_on<Interval>(thin)).exists(), Verdict::undecided);
  EXPECT_TRUE(squared_altitude(simplex_on<Interval>(thin), 1));
}

RC_GTEST_PROP(Altitude, ByProjectionByDualBasisAndByVolumesAgree, ()) {
  const auto simplex = simplex_of(*any_simplex(1, 6));
  const auto dual = squared_dual_lengths(simplex);
  RC_ASSERT(dual.exists() == is_non_degenerate(simplex));
  RC_CLASSIFY(!dual, "degenerate");
  for (std::size_t p = 0; p < simplex.vertex_count(); ++p) {
    const auto projected = squared_altitude(simplex, p);
    RC_ASSERT(projected.has_value());
    if (dual) RC_ASSERT(*projected * (*dual)[p] == Rational(1));
    const auto by_volumes = squared_altitude_by_volumes(simplex, p);
    RC_ASSERT(by_volumes.has_value() == is_proved(is_non_degenerate(simplex.opposite_facet(p))));
    if (by_volumes) RC_ASSERT(*by_volumes == *projected);
  }
}

RC_GTEST_PROP(Altitude, IsNeverLongerThanAnEdgeFromThatVertex, ()) {
  const auto simplex = simplex_of(*any_simplex(1, 6));
  for (std::size_t p = 0; p < simplex.vertex_count(); ++p) {
    for (std::size_t q = 0; q < simplex.vertex_count(); ++q) {
      if (q != p) RC_ASSERT(*squared_altitude(simplex, p) <= simplex.squared_edge(p, q));
    }
  }
}

RC_GTEST_PROP(Altitude, OnIntervalsContainsTheExactValue, ()) {
  const Points points = *any_simplex(1, 6);
  const auto exact = simplex_of(points);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Rational altitude_squared = *squared_altitude(exact, p);
    if (const auto enclosed = squared_altitude(simplex_on<BigInterval>(points), p)) {
      RC_ASSERT(contains(*enclosed, altitude_squared));
    }
    const RoundingGuard guard;
    if (const auto enclosed = squared_altitude(simplex_on<Interval>(points), p)) {
      RC_ASSERT(contains(*enclosed, altitude_squared));
      RC_ASSERT(contains(square(*altitude(simplex_on<Interval>(points), p)), altitude_squared));
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
