#include "properties/instances/space_vocabulary.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/parser.hpp"
#include "kernel/number/elementary.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/type_check.hpp"
#include "properties/instances/instance_class.hpp"
#include "support/error.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

SpaceObject octant() {
  return {Curvature::positive,
          Rational(1),
          {{Rational(0), Rational(0)}, {Rational(2), Rational(0)}, {Rational(0), Rational(2)}}};
}
SpaceObject hyperbolic_corner(const Rational& unit) {
  return {
      Curvature::negative, unit, {{Rational(0), Rational(0)}, {Rational(1), Rational(0)}, {Rational(0), Rational(1)}}};
}

Verdict verdict_of(const SpaceObject& space, const std::string& formula) {
  Bindings bindings;
  bindings["x"] = ObjectPointer(std::make_shared<SpaceObject>(space));
  const auto statement =
      type_checked(parse_formula(formula), full_vocabulary(), {{"x", types::space_points}}, types::truth);
  Scene scene(bindings);
  return decide_statement(*statement, scene);
}

TEST(SpaceVocabulary, MeasuresAnOctantOfTheSphere) {
  for (const char* pair : {"0, 1", "0, 2", "1, 2"}) {
    const std::string distance = "space_distance(x, " + std::string(pair) + ")";
    EXPECT_EQ(verdict_of(octant(), distance + " > 15707963/10000000"), Verdict::proved) << pair;
    EXPECT_EQ(verdict_of(octant(), distance + " < 15707964/10000000"), Verdict::proved) << pair;
  }
  // All angles are right: π/√2 in the chart at each corner.
  for (const char* three : {"0, 1, 2", "1, 0, 2", "2, 1, 0"}) {
    const std::string distance = "chart_distance(x, " + std::string(three) + ")";
    EXPECT_EQ(verdict_of(octant(), distance + " > 22214/10000"), Verdict::proved) << three;
    EXPECT_EQ(verdict_of(octant(), distance + " < 22215/10000"), Verdict::proved) << three;
  }
}

TEST(SpaceVocabulary, MeasuresAHyperbolicTriangleInAnyUnit) {
  // log 3, arcosh(25/9) by the law of cosines, √2 log 3.
  EXPECT_EQ(verdict_of(hyperbolic_corner(Rational(1)), "space_distance(x, 0, 1) > 10986/10000"), Verdict::proved);
  EXPECT_EQ(verdict_of(hyperbolic_corner(Rational(1)), "space_distance(x, 0, 1) < 10987/10000"), Verdict::proved);
  const BigInterval hypotenuse = area_cosine(BigInterval(ratio(25, 9)));
  const auto here = distance_in_space<BigInterval>(hyperbolic_corner(Rational(1)), 1, 2);
  EXPECT_TRUE(is_undecided(less(*here, hypotenuse)) && is_undecided(less(hypotenuse, *here)));
  EXPECT_EQ(verdict_of(hyperbolic_corner(Rational(3)), "chart_distance(x, 0, 1, 2) > 3*15536/10000"), Verdict::proved);
  EXPECT_EQ(verdict_of(hyperbolic_corner(Rational(3)), "chart_distance(x, 0, 1, 2) < 3*15537/10000"), Verdict::proved);
}

/// The distance in the space by the law of cosines, from that in the chart and the distances from its centre: the chart
/// keeps the angle at its centre.
TEST(SpaceVocabulary, TheChartKeepsLengthsAndAnglesAtItsCentre) {
  const BigInterval two(2);
  for (const Curvature curvature : {Curvature::negative, Curvature::positive}) {
    const SpaceObject space(curvature, Rational(1),
                            {{ratio(1, 3), ratio(1, 5)}, {ratio(-1, 2), ratio(2, 3)}, {ratio(1, 7), ratio(-3, 4)}});
    const BigInterval a = *distance_in_chart<BigInterval>(space, 0, 0, 1);
    const BigInterval b = *distance_in_chart<BigInterval>(space, 0, 0, 2);
    EXPECT_FALSE(is_proved(less(a, *distance_in_space<BigInterval>(space, 0, 1))));
    EXPECT_FALSE(is_proved(less(*distance_in_space<BigInterval>(space, 0, 1), a)));
    const BigInterval c = *distance_in_chart<BigInterval>(space, 0, 1, 2);
    const BigInterval cosine_of_angle = (square(a) + square(b) - square(c)) / (two * a * b);
    const BigInterval law =
        curvature == Curvature::positive
            ? cosine(a) * cosine(b) + sine(a) * sine(b) * cosine_of_angle
            : hyperbolic_cosine(a) * hyperbolic_cosine(b) - hyperbolic_sine(a) * hyperbolic_sine(b) * cosine_of_angle;
    const BigInterval expected = curvature == Curvature::positive ? arccosine(law) : area_cosine(law);
    const BigInterval found = *distance_in_space<BigInterval>(space, 1, 2);
    const BigInterval error = absolute(expected - found);
    EXPECT_TRUE(is_proved(less(error, BigInterval(Rational::power_of_two(-100)))));
  }
}

TEST(SpaceVocabulary, WhatIsTranscendentalOrAnAntipodeIsNotDecided) {
  // Both are π/2: no rung knows that.
  EXPECT_EQ(verdict_of(octant(), "space_distance(x, 0, 1) <= space_distance(x, 1, 2)"), Verdict::undecided);
  const SpaceObject poles{Curvature::positive, Rational(1), {{Rational(1), Rational(1)}, {Rational(-2), Rational(-2)}}};
  EXPECT_EQ(verdict_of(poles, "chart_distance(x, 0, 1, 0) >= 0"), Verdict::undecided);
  EXPECT_EQ(verdict_of(poles, "space_distance(x, 0, 1) > 314159/100000"), Verdict::proved);
  EXPECT_THROW((void)verdict_of(poles, "space_distance(x, 0, 2) > 0"), InputError);
  EXPECT_THROW((void)verdict_of(poles, "space_distance(x, -1, 0) > 0"), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
