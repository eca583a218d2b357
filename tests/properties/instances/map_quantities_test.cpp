#include "properties/instances/map_quantities.hpp"

#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational zero(0);

/// An edge of length 2 in the plane, and the point (1/2, 3): half from the edge's bisector, 3 above its line.
Bindings edge_and_point() {
  return {{"t", simplex({{Rational(-1), zero}, {Rational(1), zero}})}, {"x", point({ratio(1, 2), Rational(3)})}};
}

TEST(MapQuantities, PlacesAPointRelativeToASimplex) {
  const Bindings bindings = edge_and_point();
  expect_equal("distance_to_normal_space(t, x)", "1/2", bindings);
  expect_equal("distance_to_circumcentre(t, x)^2", "37/4", bindings);
  expect_equal("circumscribed_radius(t, x)^2", "45/4", bindings);
}

TEST(MapQuantities, TheBestBallIsFoundAmongAllThatAreNear) {
  const Bindings bindings = edge_and_point();
  // Centres (0, ν): within 1/2 only ν = 3, of radius √10.
  expect_equal("radius_misfit(t, x, 1/2, 4)", "4 - sqrt(10)", bindings);
  // Within √(1/4 + 1): ν from 2 to 4, radii from √5 to √17.
  expect_equal("radius_misfit(t, x, sqrt(5)/2, 5)", "5 - sqrt(17)", bindings);
  expect_equal("radius_misfit(t, x, sqrt(5)/2, 2)", "sqrt(5) - 2", bindings);
  expect_equal("radius_misfit(t, x, sqrt(5)/2, 3)", "0", bindings);
  // Within √(1/4 + 16): past the edge, where the radius is least, 1.
  expect_equal("radius_misfit(t, x, sqrt(65)/2, 1/3)", "2/3", bindings);
  // Nothing is within 1/4.
  EXPECT_EQ(verdict("radius_misfit(t, x, 1/4, 4) >= 0", bindings), Verdict::undecided);
}

TEST(MapQuantities, WithoutNormalSpaceThereIsOneBall) {
  const Bindings bindings{{"t", simplex({{zero}, {Rational(4)}})}, {"x", point({Rational(3)})}};
  expect_equal("distance_to_normal_space(t, x)", "1", bindings);
  expect_equal("distance_to_circumcentre(t, x)", "1", bindings);
  expect_equal("radius_misfit(t, x, 5, 3/2)", "1/2", bindings);
}

TEST(MapQuantities, AgreesWithTheDistancesFromTheVertices) {
  // (|x − p_0|² − |x − p_1|²)/2Δ is the distance from the bisector.
  const Bindings bindings{{"t", simplex({{zero, zero, zero}, {Rational(2), Rational(2), Rational(1)}})},
                          {"x", point({Rational(5), Rational(-1), Rational(7)})}};
  // |x|² = 75, |x − p_1|² = 9 + 9 + 36 = 54, Δ = 3.
  expect_equal("distance_to_normal_space(t, x)", "7/2", bindings);
  // C = (1, 1, 1/2).
  expect_equal("distance_to_circumcentre(t, x)^2", "16 + 4 + 169/4", bindings);
}

TEST(MapQuantities, DegenerateSimplicesHaveNone) {
  const Bindings bindings{{"t", simplex({{zero, zero}, {Rational(1), zero}, {Rational(3), zero}})},
                          {"x", point({zero, Rational(1)})}};
  EXPECT_EQ(verdict("distance_to_normal_space(t, x) >= 0", bindings), Verdict::undecided);
  EXPECT_EQ(verdict("distance_to_circumcentre(t, x) >= 0", bindings), Verdict::undecided);
  EXPECT_EQ(verdict("radius_misfit(t, x, 1, 1) >= 0", bindings), Verdict::undecided);
}

TEST(MapQuantities, PointsOfAnotherSpaceAreRefused) {
  const Bindings bindings{{"t", simplex({{zero}, {Rational(4)}})}, {"x", point({zero, zero})}};
  EXPECT_THROW((void)verdict("distance_to_normal_space(t, x) >= 0", bindings), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
