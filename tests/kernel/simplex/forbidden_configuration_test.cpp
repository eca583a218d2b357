#include "kernel/simplex/forbidden_configuration.hpp"

#include "kernel/number/algebraic.hpp"
#include "tests/kernel/simplex/naive_reference.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational tiny = Rational::power_of_two(-300);

/// Four vertices of a square of side 1 in ℝ²: all facets are right isosceles triangles, of thickness 1/4, R² = 1/2.
const Points unit_square{
    {Rational(0), Rational(0)}, {Rational(1), Rational(0)}, {Rational(1), Rational(1)}, {Rational(0), Rational(1)}};

using Parameters = ForbiddenConfigurationParameters<Rational>;
using Properties = ForbiddenPropertiesParameters<Rational>;

TEST(ForbiddenConfiguration, TheSquareIsOneInThePlane) {
  EXPECT_EQ(is_forbidden_configuration(simplex_of(unit_square), 2, Parameters{ratio(1, 4), Rational(1), Rational(0)}),
            Verdict::proved);
}

TEST(ForbiddenConfiguration, NeedsABallSmallerThanTheSamplingRadius) {
  const auto simplex = simplex_of(unit_square);
  EXPECT_EQ(is_forbidden_configuration(simplex, 2, Parameters{ratio(1, 4), ratio(1, 2), Rational(0)}),
            Verdict::refuted);
  EXPECT_EQ(is_forbidden_configuration(simplex, 2, Parameters{ratio(1, 4), ratio(1, 2) + tiny, Rational(0)}),
            Verdict::proved);
}

TEST(ForbiddenConfiguration, MustBeAFlake) {
  EXPECT_EQ(
      is_forbidden_configuration(simplex_of(unit_square), 2, Parameters{ratio(1, 4) + tiny, Rational(1), Rational(0)}),
      Verdict::refuted);
  // A good tetrahedron, however large the protection.
  EXPECT_EQ(
      is_forbidden_configuration(simplex_of(right_corner(3)), 3, Parameters{ratio(1, 4), Rational(1), Rational(1)}),
      Verdict::refuted);
}

TEST(ForbiddenConfiguration, MustHaveAVertexWithinTheProtection) {
  // Three vertices of the square, and a point on the diagonal at √2/2 + x√2 from the centre, x = 2⁻²⁰.
  Points moved = unit_square;
  const Rational x = Rational::power_of_two(-20);
  moved[2] = {Rational(1) + x, Rational(1) + x};
  const auto simplex = simplex_of(moved);
  EXPECT_EQ(is_forbidden_configuration(simplex, 2, Parameters{ratio(1, 5), Rational(1), Rational(2) * x * x}),
            Verdict::proved);
  EXPECT_EQ(is_forbidden_configuration(simplex, 2, Parameters{ratio(1, 5), Rational(1), x * x / Rational(16)}),
            Verdict::refuted);
}

TEST(ForbiddenConfiguration, HasAtMostTwoVerticesMoreThanTheDimension) {
  EXPECT_EQ(is_forbidden_configuration(simplex_of(unit_square), 1, Parameters{ratio(1, 4), Rational(1), Rational(1)}),
            Verdict::refuted);
  EXPECT_EQ(
      is_forbidden_configuration(simplex_of({{Rational(1)}}), 1, Parameters{ratio(1, 4), Rational(1), Rational(1)}),
      Verdict::refuted);
}

// In ℝ³ the facets of a sliver have a pencil of circumscribing balls; one of them can pass through a fourth point that
// is far from the smallest.
TEST(ForbiddenConfiguration, LooksAtAllCircumscribingBallsNotOnlyTheSmallest) {
  Points sliver = unit_square;
  for (auto& point : sliver) point.push_back(Rational(0));
  sliver[2] = {ratio(9, 10), ratio(9, 10), ratio(1, 100)};
  const auto simplex = simplex_of(sliver);
  const Rational parameter = ratio(1, 9);
  ASSERT_EQ(is_flake(simplex, parameter), Verdict::proved);
  // The only sphere through all four points has the centre (1/2, 1/2, −1799/200).
  const Rational squared_radius = ratio(1, 2) + square(ratio(1799, 200));
  EXPECT_EQ(is_forbidden_configuration(simplex, 3, Parameters{parameter, squared_radius + tiny, Rational(0)}),
            Verdict::proved);
  EXPECT_EQ(is_forbidden_configuration(simplex, 3, Parameters{parameter, squared_radius, Rational(0)}),
            Verdict::refuted);
}

TEST(ForbiddenProperties, TheSquareHasAllFour) {
  const Properties parameters{ratio(1, 4), Rational(0), Rational(1), Rational(2)};
  EXPECT_EQ(has_forbidden_properties(simplex_of(unit_square), parameters), Verdict::proved);
}

TEST(ForbiddenProperties, EachIsNeeded) {
  const auto simplex = simplex_of(unit_square);
  const Properties base{ratio(1, 4), Rational(0), Rational(1), Rational(2)};
  {  // P1
    Points moved = unit_square;
    moved[2] = {Rational(1), Rational(1) + Rational::power_of_two(-30)};
    Properties parameters = base;
    parameters.squared_flake_parameter = ratio(1, 5);
    EXPECT_EQ(has_forbidden_properties(simplex_of(moved), parameters), Verdict::refuted);
    parameters.squared_hoop_bound = Rational::power_of_two(-50);
    EXPECT_EQ(has_forbidden_properties(simplex_of(moved), parameters), Verdict::proved);
  }
  {  // P2: R² = 1/2 against 4ε²
    Points half = unit_square;
    for (auto& point : half) {
      for (auto& coordinate : point) coordinate *= Rational(7);
    }
    half[0] = {Rational(6), Rational(8)};  // with the next two on the circle of radius 5 about (3, 4)
    half[1] = {Rational(0), Rational(8)};
    half[2] = {Rational(0), Rational(0)};
    half[3] = {Rational(6), Rational(0)};
    Properties parameters{ratio(1, 8), Rational(0), ratio(5, 2), Rational(20)};
    EXPECT_EQ(has_forbidden_properties(simplex_of(half), parameters), Verdict::refuted);
    parameters.sampling_radius = ratio(5, 2) + tiny;
    EXPECT_EQ(has_forbidden_properties(simplex_of(half), parameters), Verdict::proved);
    parameters.edge_bound = Rational(10);  // P3: the diagonal is 10
    EXPECT_EQ(has_forbidden_properties(simplex_of(half), parameters), Verdict::refuted);
    parameters.edge_bound = Rational(10) + tiny;
    EXPECT_EQ(has_forbidden_properties(simplex_of(half), parameters), Verdict::proved);
  }
  {  // P4
    Properties parameters = base;
    parameters.squared_flake_parameter = ratio(1, 4) + tiny;
    EXPECT_EQ(has_forbidden_properties(simplex, parameters), Verdict::refuted);
  }
}

TEST(ForbiddenProperties, AreRefutedWhereAFacetIsDegenerate) {
  const Points collinear{
      {Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}, {Rational(0), Rational(1)}};
  EXPECT_EQ(has_forbidden_properties(simplex_of(collinear), Properties{Rational::power_of_two(-60), Rational(1000),
                                                                       Rational(1000), Rational(9)}),
            Verdict::refuted);
  EXPECT_EQ(has_forbidden_properties(simplex_of({{Rational(0)}}),
                                     Properties{ratio(1, 4), Rational(1), Rational(1), Rational(1)}),
            Verdict::refuted);
}

/// k+2 points of a sphere or of ℝᵐ, m ∈ {k, k+1}, close to cospherical, by inverse stereographic projection.
Points near_sphere(std::size_t count, std::size_t m) {
  const Rational nudge = Rational::power_of_two(-*rc::gen::inRange(1, 80)) * Rational(*rc::gen::inRange(0, 2));
  Points result;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Rational> parameter;
    Rational squared(0);
    for (std::size_t axis = 0; axis + 1 < m; ++axis) {
      parameter.push_back(ratio(*rc::gen::inRange(-30, 31), 10));
      squared += square(parameter.back());
    }
    std::vector<Rational> point;
    for (const Rational& coordinate : parameter) point.push_back(Rational(2) * coordinate / (squared + Rational(1)));
    point.push_back((squared - Rational(1)) / (squared + Rational(1)) + (i == 0 ? nudge : Rational(0)));
    result.push_back(point);
  }
  return result;
}

RC_GTEST_PROP(ForbiddenConfiguration, AgreesWithItsPartsOnNearlyCosphericalPoints, ()) {
  const auto m = static_cast<std::size_t>(*rc::gen::inRange(1, 4));
  const auto count = static_cast<std::size_t>(*rc::gen::inRange(2, static_cast<int>(m) + 3));
  const auto simplex = simplex_of(near_sphere(count, m));
  const Parameters parameters{ratio(1, *rc::gen::element(4, 30, 1000)), *rc::gen::element(ratio(9, 10), ratio(11, 10)),
                              Rational::power_of_two(-*rc::gen::inRange(0, 60))};
  bool near_some_ball = false;
  for (std::size_t p = 0; p < count; ++p) {
    if (const auto offset = sphere_offset(simplex, p)) {
      near_some_ball = near_some_ball ||
                       is_proved(has_circumscribing_ball_near(
                           *offset, m + 2 - count, parameters.squared_sampling_radius, parameters.squared_protection));
    }
  }
  const Verdict verdict = is_forbidden_configuration(simplex, m, parameters);
  RC_CLASSIFY(is_proved(verdict), "forbidden");
  RC_ASSERT(verdict == verdict_of(naive_flake(simplex, parameters.squared_flake_parameter) && near_some_ball));
}

RC_GTEST_PROP(ForbiddenProperties, AgreeWithTheirPartsOnNearlyCosphericalPoints, ()) {
  const auto m = static_cast<std::size_t>(*rc::gen::inRange(2, 4));
  const auto count = static_cast<std::size_t>(*rc::gen::inRange(3, static_cast<int>(m) + 3));
  const auto simplex = simplex_of(near_sphere(count, m));
  const Properties parameters{ratio(1, *rc::gen::element(4, 30, 1000)),
                              Rational::power_of_two(-*rc::gen::inRange(-8, 60)),
                              *rc::gen::element(ratio(1, 2), Rational(1)), *rc::gen::element(ratio(9, 5), Rational(3))};
  bool expected = is_proved(has_hoop_property(simplex, parameters.squared_hoop_bound)) &&
                  squared_longest_edge(simplex) < square(parameters.edge_bound);
  for (std::size_t p = 0; p < count; ++p) {
    const auto facet = simplex.opposite_facet(p);
    const auto radius = squared_circumradius_by_volumes(facet);
    expected = expected && radius && *radius < Rational(4) * square(parameters.sampling_radius) &&
               naive_good(facet, parameters.squared_flake_parameter);
  }
  const Verdict verdict = has_forbidden_properties(simplex, parameters);
  RC_CLASSIFY(is_proved(verdict), "has all");
  RC_ASSERT(verdict == verdict_of(expected));
}

RC_GTEST_PROP(ForbiddenConfiguration, OnIntervalsNeverContradictsTheExactVerdict, ()) {
  const auto m = static_cast<std::size_t>(*rc::gen::inRange(1, 4));
  const auto count = static_cast<std::size_t>(*rc::gen::inRange(2, static_cast<int>(m) + 3));
  const Points points = near_sphere(count, m);
  const Parameters definition{ratio(1, 30), ratio(11, 10), Rational::power_of_two(-*rc::gen::inRange(0, 60))};
  const Properties summary{ratio(1, 30), Rational::power_of_two(-*rc::gen::inRange(0, 60)), Rational(1), Rational(3)};
  const Verdict forbidden = is_forbidden_configuration(simplex_of(points), m, definition);
  const Verdict properties = has_forbidden_properties(simplex_of(points), summary);
  const auto check = [&]<class S>(const EdgeGram<S>& simplex) {
    return agrees(is_forbidden_configuration(simplex, m, definition.on<S>()), forbidden) &&
           agrees(has_forbidden_properties(simplex, summary.on<S>()), properties);
  };
  RC_ASSERT(check(simplex_on<BigInterval>(points)));
  const RoundingGuard guard;
  RC_ASSERT(check(simplex_on<Interval>(points)));
}

TEST(ForbiddenConfiguration, FourCornersOfARegularOctagonAreOneOnAlgebraicNumbers) {
  const Algebraic c = square_root(Algebraic(ratio(1, 2)));
  // Corners of the octagon on the unit circle, at 45°, 135°, 225° and 270°.
  std::vector<std::vector<Algebraic>> points{{c, c}, {-c, c}, {-c, -c}, {Algebraic(0), Algebraic(-1)}};
  const ForbiddenConfigurationParameters<Algebraic> parameters{Algebraic(ratio(1, 100)), Algebraic(2), Algebraic(0)};
  const ForbiddenPropertiesParameters<Algebraic> properties{Algebraic(ratio(1, 100)), Algebraic(0), Algebraic(1),
                                                            Algebraic(3)};
  EXPECT_EQ(is_forbidden_configuration(edge_gram_from_points(points), 2, parameters), Verdict::proved);
  EXPECT_EQ(has_forbidden_properties(edge_gram_from_points(points), properties), Verdict::proved);
  points[3][1] -= Algebraic(Rational::power_of_two(-100));
  EXPECT_EQ(is_forbidden_configuration(edge_gram_from_points(points), 2, parameters), Verdict::refuted);
  EXPECT_EQ(has_forbidden_properties(edge_gram_from_points(points), properties), Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
