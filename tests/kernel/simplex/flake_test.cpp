#include "kernel/simplex/flake.hpp"

#include "kernel/number/algebraic.hpp"
#include "tests/kernel/simplex/naive_reference.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The square as a flat tetrahedron: its facets are right isosceles triangles.
const Points square_tetrahedron{{Rational(0), Rational(0), Rational(0)},
                                {Rational(1), Rational(0), Rational(0)},
                                {Rational(1), Rational(1), Rational(0)},
                                {Rational(0), Rational(1), Rational(0)}};

TEST(Flake, ADegenerateSliverWithGoodFacetsIsOne) {
  const auto sliver = simplex_of(square_tetrahedron);
  EXPECT_EQ(is_flake(sliver, ratio(1, 4)), Verdict::proved);
  // With Γ > 1/2 its facets are not good: they are the flakes.
  const Rational parameter = ratio(1, 4) + Rational::power_of_two(-300);
  EXPECT_EQ(is_flake(sliver, parameter), Verdict::refuted);
  EXPECT_EQ(find_flake(sliver, parameter)->size(), 3U);
  EXPECT_EQ(*find_flake(sliver, ratio(1, 4)), (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(Flake, AGoodSimplexIsNone) {
  EXPECT_EQ(is_flake(simplex_of(right_corner(3)), ratio(1, 4)), Verdict::refuted);
  EXPECT_EQ(find_flake(simplex_of(right_corner(3)), ratio(1, 4)).exists(), Verdict::refuted);
}

TEST(Flake, VerticesAndProperEdgesAreNone) {
  EXPECT_EQ(is_flake(simplex_of({{Rational(3)}}), Rational(1)), Verdict::refuted);
  EXPECT_EQ(is_flake(simplex_of({{Rational(3)}, {Rational(4)}}), Rational(1)), Verdict::refuted);
  EXPECT_EQ(is_flake(simplex_of({{Rational(3)}, {Rational(3)}}), Rational(1)), Verdict::proved);
}

TEST(Flake, AThinTriangleBesideABadEdgeIsNone) {
  const Points doubled{{Rational(0), Rational(0)}, {Rational(0), Rational(0)}, {Rational(0), Rational(1)}};
  EXPECT_EQ(is_flake(simplex_of(doubled), ratio(1, 100)), Verdict::refuted);
  EXPECT_EQ(*find_flake(simplex_of(doubled), ratio(1, 100)), (std::vector<std::size_t>{0, 1}));
}

TEST(Flake, OnIntervalsIsNotNamedWhileASmallerFaceMayBeOne) {
  Points thirds = square_tetrahedron;
  for (auto& point : thirds) {
    for (auto& coordinate : point) coordinate = coordinate / Rational(3);
  }
  const RoundingGuard guard;
  const auto sliver = simplex_on<Interval>(thirds);
  EXPECT_EQ(find_flake(sliver, scalar_from<Interval>(ratio(1, 4))).exists(), Verdict::undecided);
  EXPECT_EQ(find_flake(sliver, scalar_from<Interval>(ratio(1, 5)))->size(), 4U);
  EXPECT_EQ(find_flake(sliver, scalar_from<Interval>(ratio(1, 3)))->size(), 3U);
}

RC_GTEST_PROP(Flake, AgreesWithTheDefinition, ()) {
  const auto simplex = simplex_of(*any_simplex(0, 5));
  const Rational parameter = any_squared_flake_parameter(simplex);
  RC_PRE(parameter <= Rational(1));
  const Verdict flake = is_flake(simplex, parameter);
  RC_CLASSIFY(is_proved(flake), "flake");
  RC_ASSERT(flake == verdict_of(naive_flake(simplex, parameter)));
}

RC_GTEST_PROP(Flake, IsAFaceOfEverySimplexThatIsNotGoodAndOfNoOther, ()) {
  const auto simplex = simplex_of(*any_simplex(0, 5));
  const Rational parameter = any_squared_flake_parameter(simplex);
  RC_PRE(parameter <= Rational(1));
  const auto found = find_flake(simplex, parameter);
  RC_ASSERT(found.exists() == negation(is_good(simplex, parameter)));
  bool any = false;
  for (const auto& face : all_faces(simplex)) any = any || is_proved(is_flake(face, parameter));
  RC_ASSERT(any == found.has_value());
  if (found) RC_ASSERT(naive_flake(simplex.face(*found), parameter));
}

RC_GTEST_PROP(Flake, OnIntervalsNeverContradictsTheExactVerdict, ()) {
  const Points points = *any_simplex(0, 5);
  const Rational parameter = any_squared_flake_parameter(simplex_of(points));
  RC_PRE(parameter <= Rational(1));
  const Verdict exact = is_flake(simplex_of(points), parameter);
  RC_ASSERT(agrees(is_flake(simplex_on<BigInterval>(points), BigInterval(parameter)), exact));
  const RoundingGuard guard;
  const auto enclosed = simplex_on<Interval>(points);
  RC_ASSERT(agrees(is_flake(enclosed, scalar_from<Interval>(parameter)), exact));
  if (const auto found = find_flake(enclosed, scalar_from<Interval>(parameter))) {
    RC_ASSERT(naive_flake(simplex_of(points).face(*found), parameter));
  }
}

TEST(Flake, IsSharpAtAnIrrationalThreshold) {
  const auto triangle = edge_gram_from_points(points_on<Algebraic>(regular_simplex(2)));
  const Algebraic threshold = square_root(Algebraic(3)) / Algebraic(4);
  EXPECT_EQ(is_flake(triangle, threshold), Verdict::refuted);
  EXPECT_EQ(is_flake(triangle, threshold + Algebraic(Rational::power_of_two(-200))), Verdict::proved);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
