#include "kernel/simplex/good.hpp"

#include "kernel/number/algebraic.hpp"
#include "tests/kernel/simplex/naive_reference.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

// A right corner in the plane has thickness 1/4, so it is Γ-good exactly for Γ ≤ 1/2.
TEST(Good, IsSharpForTheRightTriangle) {
  const auto triangle = simplex_of(right_corner(2));
  EXPECT_EQ(is_good(triangle, ratio(1, 4)), Verdict::proved);
  EXPECT_EQ(is_good(triangle, ratio(1, 4) + Rational::power_of_two(-300)), Verdict::refuted);
}

TEST(Good, LooksAtAllFaces) {
  // A thick tetrahedron never has a thin facet, but the bound Γʲ is stricter for the facet: thickness of the facet
  // 1/4 against Γ², of the tetrahedron √(1/54) ≥ Γ³ up to Γ ≈ 0.5143.
  const auto corner = simplex_of(right_corner(3));
  const Rational parameter = square(ratio(51, 100));
  EXPECT_EQ(is_thickness_at_least(corner, power(parameter, 3)), Verdict::proved);
  EXPECT_EQ(is_good(corner, parameter), Verdict::refuted);
  EXPECT_EQ(is_good(corner, ratio(1, 4)), Verdict::proved);
  EXPECT_EQ(are_facets_good(corner, parameter), Verdict::refuted);
  EXPECT_EQ(are_facets_good(corner, ratio(1, 4)), Verdict::proved);
}

TEST(Good, VerticesAndEdgesAreGoodForEveryParameter) {
  EXPECT_EQ(is_good(simplex_of({{Rational(3)}}), Rational(1)), Verdict::proved);
  EXPECT_EQ(is_good(simplex_of({{Rational(3)}, {ratio(1, 3)}}), Rational(1)), Verdict::proved);
  EXPECT_EQ(are_facets_good(simplex_of({{Rational(3)}}), Rational(1)), Verdict::proved);
  EXPECT_EQ(is_good(simplex_of({{Rational(3)}, {Rational(3)}}), Rational::power_of_two(-100)), Verdict::refuted);
}

RC_GTEST_PROP(Good, AgreesWithTheDefinition, ()) {
  const auto simplex = simplex_of(*any_simplex(0, 5));
  const Rational parameter = any_squared_flake_parameter(simplex);
  RC_PRE(parameter <= Rational(1));
  const Verdict good = is_good(simplex, parameter);
  RC_CLASSIFY(is_proved(good), "good");
  RC_ASSERT(good == verdict_of(naive_good(simplex, parameter)));
  bool facets = true;
  for (std::size_t p = 0; p < simplex.vertex_count() && simplex.dimension() > 0; ++p) {
    facets = facets && naive_good(simplex.opposite_facet(p), parameter);
  }
  RC_ASSERT(are_facets_good(simplex, parameter) == verdict_of(facets));
}

RC_GTEST_PROP(Good, IsInheritedByFacesAndBySmallerParameters, ()) {
  const auto simplex = simplex_of(*any_simplex(1, 5));
  const Rational parameter = any_squared_flake_parameter(simplex);
  RC_PRE(parameter <= Rational(1) && is_proved(is_good(simplex, parameter)));
  RC_ASSERT(is_good(simplex, parameter / Rational(2)) == Verdict::proved);
  for (const auto& face : all_faces(simplex)) RC_ASSERT(is_good(face, parameter) == Verdict::proved);
}

RC_GTEST_PROP(Good, OnIntervalsNeverContradictsTheExactVerdict, ()) {
  const Points points = *any_simplex(0, 5);
  const Rational parameter = any_squared_flake_parameter(simplex_of(points));
  RC_PRE(parameter <= Rational(1));
  const Verdict exact = is_good(simplex_of(points), parameter);
  RC_ASSERT(agrees(is_good(simplex_on<BigInterval>(points), BigInterval(parameter)), exact));
  const RoundingGuard guard;
  RC_ASSERT(agrees(is_good(simplex_on<Interval>(points), scalar_from<Interval>(parameter)), exact));
}

// The regular triangle has thickness √3/4: good exactly for Γ₀² ≤ √3/4, a threshold that is not rational.
TEST(Good, IsSharpAtAnIrrationalThreshold) {
  const auto triangle = edge_gram_from_points(points_on<Algebraic>(regular_simplex(2)));
  const Algebraic threshold = square_root(Algebraic(3)) / Algebraic(4);
  EXPECT_EQ(is_good(triangle, threshold), Verdict::proved);
  EXPECT_EQ(is_good(triangle, threshold + Algebraic(Rational::power_of_two(-200))), Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
