#include "kernel/simplex/simplex_decisions.hpp"

#include "kernel/simplex/cayley_menger.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/realisability.hpp"
#include "kernel/simplex/singular_values.hpp"
#include "tests/kernel/simplex/naive_reference.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational tiny = Rational::power_of_two(-200);

// Each decision at its exact threshold and just beyond it.
TEST(SimplexDecisions, AreSharpOnTheRightTriangle) {
  const auto simplex = ExactSimplex::from_points(right_corner(2));
  EXPECT_EQ(decide_non_degenerate(simplex), Verdict::proved);
  EXPECT_EQ(decide_altitude_at_least(simplex, 0, ratio(1, 2)), Verdict::proved);
  EXPECT_EQ(decide_altitude_at_least(simplex, 0, ratio(1, 2) + tiny), Verdict::refuted);
  EXPECT_EQ(decide_thickness_at_least(simplex, ratio(1, 16)), Verdict::proved);
  EXPECT_EQ(decide_thickness_at_least(simplex, ratio(1, 16) + tiny), Verdict::refuted);
  EXPECT_EQ(decide_circumradius_below(simplex, ratio(1, 2)), Verdict::refuted);
  EXPECT_EQ(decide_circumradius_below(simplex, ratio(1, 2) + tiny), Verdict::proved);
  EXPECT_EQ(decide_smallest_singular_value_at_least(simplex, Rational(1)), Verdict::proved);
  EXPECT_EQ(decide_smallest_singular_value_at_least(simplex, Rational(1) + tiny), Verdict::refuted);
  EXPECT_EQ(decide_largest_singular_value_at_most(simplex, Rational(1)), Verdict::proved);
  EXPECT_EQ(decide_largest_singular_value_at_most(simplex, Rational(1) - tiny), Verdict::refuted);
  EXPECT_EQ(decide_circumsphere_within(simplex, 1, Rational(1)), Verdict::proved);
  EXPECT_EQ(decide_circumsphere_within(simplex, 1, Rational(1) - tiny), Verdict::refuted);
  // (√5 − 1)/2 from the circle about the opposite edge.
  EXPECT_EQ(decide_diametric_sphere_within(simplex, 1, ratio(382, 1000)), Verdict::proved);
  EXPECT_EQ(decide_diametric_sphere_within(simplex, 1, ratio(381, 1000)), Verdict::refuted);
  EXPECT_EQ(decide_good(simplex, ratio(1, 4)), Verdict::proved);
  EXPECT_EQ(decide_good(simplex, ratio(1, 4) + tiny), Verdict::refuted);
  EXPECT_EQ(decide_flake(simplex, ratio(1, 4)), Verdict::refuted);
  EXPECT_EQ(decide_flake(simplex, ratio(1, 4) + tiny), Verdict::proved);
  EXPECT_EQ(decide_hoop_property(simplex, Rational(4)), Verdict::proved);
  EXPECT_EQ(decide_hoop_property(simplex, Rational(4) - tiny), Verdict::refuted);
}

TEST(SimplexDecisions, AreSharpOnTheSquare) {
  const auto square_simplex = ExactSimplex::from_points(
      {{Rational(0), Rational(0)}, {Rational(1), Rational(0)}, {Rational(1), Rational(1)}, {Rational(0), Rational(1)}});
  EXPECT_EQ(decide_non_degenerate(square_simplex), Verdict::refuted);
  EXPECT_EQ(decide_forbidden_configuration(square_simplex, 2, {ratio(1, 4), ratio(1, 2) + tiny, Rational(0)}),
            Verdict::proved);
  EXPECT_EQ(decide_forbidden_configuration(square_simplex, 2, {ratio(1, 4), ratio(1, 2), Rational(0)}),
            Verdict::refuted);
  EXPECT_EQ(decide_forbidden_properties(square_simplex, {ratio(1, 4), Rational(0), Rational(1), Rational(2)}),
            Verdict::proved);
  EXPECT_EQ(decide_forbidden_properties(square_simplex, {ratio(1, 4), Rational(0), ratio(1, 4), Rational(2)}),
            Verdict::refuted);
}

TEST(SimplexDecisions, OfWhatDoesNotExistAreRefuted) {
  const auto collinear =
      ExactSimplex::from_points({{Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}});
  EXPECT_EQ(decide_circumradius_below(collinear, Rational(1000000)), Verdict::refuted);
}

RC_GTEST_PROP(SimplexDecisions, AlwaysDecideAsTheRationalsDo, ()) {
  const Points points = *any_simplex(1, 4);
  const auto exact = simplex_of(points);
  const auto by_points = ExactSimplex::from_points(points);
  const auto by_edges = ExactSimplex::from_squared_edges(squared_distance_matrix(exact));
  const Rational thickness = naive_squared_thickness(exact);
  const Rational bound =
      thickness > Rational(0) && *rc::gen::inRange(0, 2) == 0 ? thickness : any_squared_flake_parameter(exact);
  RC_PRE(bound <= Rational(1));
  const auto offset = sphere_offset(exact, 0);
  const Verdict within = offset ? is_circumsphere_within(*offset, bound) : Verdict::refuted;
  const Verdict diametric = offset ? is_diametric_sphere_within(*offset, bound) : Verdict::refuted;
  const auto radius = squared_circumradius(exact);
  for (const auto& simplex : {by_points, by_edges}) {
    RC_ASSERT(decide_non_degenerate(simplex) == is_non_degenerate(exact));
    RC_ASSERT(decide_altitude_at_least(simplex, 0, bound) == verdict_of(*squared_altitude(exact, 0) >= bound));
    RC_ASSERT(decide_thickness_at_least(simplex, bound) == verdict_of(thickness >= bound));
    RC_ASSERT(decide_circumradius_below(simplex, bound) == verdict_of(radius && *radius < bound));
    RC_ASSERT(decide_smallest_singular_value_at_least(simplex, bound) ==
              is_smallest_singular_value_at_least(exact, bound));
    RC_ASSERT(decide_largest_singular_value_at_most(simplex, bound) == is_largest_singular_value_at_most(exact, bound));
    RC_ASSERT(decide_circumsphere_within(simplex, 0, bound) == within);
    RC_ASSERT(decide_diametric_sphere_within(simplex, 0, bound) == diametric);
    RC_ASSERT(decide_good(simplex, bound) == verdict_of(naive_good(exact, bound)));
    RC_ASSERT(decide_flake(simplex, bound) == verdict_of(naive_flake(exact, bound)));
    RC_ASSERT(decide_hoop_property(simplex, bound) == has_hoop_property(exact, bound));
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
