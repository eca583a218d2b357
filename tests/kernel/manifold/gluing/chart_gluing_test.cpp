#include "kernel/manifold/gluing/chart_gluing.hpp"

#include <gtest/gtest.h>

#include <array>

#include "kernel/manifold/gluing/piecewise_values.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/gluing/atlas_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

FormulaAtlasDescription sphere() { return two_charts(Rational(2), ratio(3, 2), inversion()); }

TEST(ChartGluing, has_transitions_in_both_directions) {
  const ChartGluing gluing(sphere());
  ASSERT_EQ(gluing.transitions().size(), 2U);
  EXPECT_EQ(gluing.transitions()[0].to, 1U);
  EXPECT_EQ(gluing.transitions()[1].to, 0U);
  EXPECT_EQ(gluing.transitions()[1].name, "the inverse of transition 1, from n to s");
  EXPECT_EQ(ChartGluing::opposite(0), 1U);
  EXPECT_EQ(ChartGluing::opposite(1), 0U);
  // The only thing that may not vanish is the denominator.
  ASSERT_EQ(gluing.transitions()[0].pieces[0].nonzero().size(), 1U);
  EXPECT_EQ(gluing.transitions()[0].pieces[0].nonzero()[0].text(), "x0^2 + x1^2");
}

TEST(ChartGluing, sees_conditions_from_the_other_side) {
  auto description = sphere();
  description.transitions[0].where = {"x - 1/4"};
  const ChartGluing gluing(description);
  EXPECT_EQ(gluing.transitions()[0].pieces[0].positive()[0].text(), "x0 - 1/4");
  // u/(u² + v²) − 1/4, times the square of the denominator.
  const Polynomial& seen = gluing.transitions()[1].pieces[0].positive().at(0);
  EXPECT_GT(seen.at({Rational(1), Rational(1)}), Rational(0));
  EXPECT_LT(seen.at({Rational(-1), Rational(1)}), Rational(0));
  EXPECT_EQ(seen.at({Rational(4), Rational(0)}), Rational(0));
}

TEST(ChartGluing, knows_where_a_map_is_not_injective) {
  // (x, xy) takes the line x = 0 to a point.
  const ChartGluing gluing(two_charts(Rational(2), Rational(1), {0, 1, {"x", "x*y"}, {"u", "v/u"}, {}}));
  ASSERT_EQ(gluing.transitions()[0].pieces[0].nonzero().size(), 1U);
  EXPECT_EQ(gluing.transitions()[0].pieces[0].nonzero()[0].text(), "x0");
}

TEST(ChartGluing, refuses_an_inverse_that_is_wrong_in_the_last_digit) {
  auto description =
      two_charts(Rational(2), Rational(1), {0, 1, {"x/3 + 333333/1000000", "y"}, {"3*u - 999999/1000000", "v"}, {}});
  EXPECT_NO_THROW((void)ChartGluing(description));
  description.transitions[0].inverse[0] = "3*u - 999998/1000000";
  const auto refusal = message_of<Rejection>([&] { (void)ChartGluing(description); });
  EXPECT_EQ(refusal,
            "two: transition 1, from n to s: atlas.inverse: the inverse of map is not the identity: coordinate 1 is "
            "not x");
}

TEST(ChartGluing, refuses_a_map_that_has_no_inverse) {
  const auto refusal = message_of<Rejection>([&] {
    (void)ChartGluing(two_charts(Rational(2), Rational(1), {0, 1, {"x", "x"}, {"u", "1/(u - v)"}, {}}));
  });
  EXPECT_TRUE(mentions(refusal, "atlas.inverse"));
}

TEST(ChartGluing, refuses_what_is_no_rational_function) {
  const auto refusal = [](const std::string& map, const std::string& where) {
    auto description = two_charts(Rational(2), Rational(1), {0, 1, {map, "y"}, {"u", "v"}, {where}});
    return message_of<InputError>([&] { (void)ChartGluing(description); });
  };
  EXPECT_EQ(refusal("x", "x"), "accepted");
  EXPECT_TRUE(mentions(refusal("sin(x)", "x"), "two: transition 1, from n to s: map, formula 1: not a rational"));
  EXPECT_TRUE(mentions(refusal("((x + y)^100)^100", "x"), "too large"));
  EXPECT_TRUE(mentions(refusal("1/(x - x)", "x"), "map, formula 1"));
  EXPECT_TRUE(mentions(refusal("x", "1/x"), "where: not a polynomial"));
}

/// (x, y) goes to (x + |y|/3, y): two pieces that meet in the line y = 0.
FormulaAtlasDescription folded(const std::string& map, const std::string& inverse) {
  return two_charts(Rational(2), Rational(1), {0, 1, {map, "y"}, {inverse, "v"}, {"x + 1"}});
}

TEST(ChartGluing, takes_piecewise_linear_maps_apart) {
  const ChartGluing gluing(folded("x + abs(y)/3", "u - abs(v)/3"));
  const auto& pieces = gluing.transitions()[0].pieces;
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].nonnegative().at(0).text(), "x1");
  EXPECT_EQ(pieces[0].map()[0].numerator.text(), "x0 + 1/3*x1");
  EXPECT_EQ(pieces[1].nonnegative().at(0).text(), "-x1");
  EXPECT_EQ(pieces[1].map()[0].numerator.text(), "x0 - 1/3*x1");
  // Conditions are seen from each piece of the other side.
  EXPECT_EQ(gluing.transitions()[1].pieces[0].positive().at(0).text(), "x0 - 1/3*x1 + 1");
  EXPECT_EQ(gluing.transitions()[1].pieces[1].positive().at(0).text(), "x0 + 1/3*x1 + 1");
}

// Defect: an absolute value of a constant was refused as an unknown function.
TEST(ChartGluing, takes_absolute_values_of_constants_for_numbers) {
  const auto gluing_of = [](const std::string& map) {
    return ChartGluing(two_charts(Rational(2), Rational(1), {0, 1, {map, "y"}, {"u/2", "v"}, {}}));
  };
  const ChartGluing gluing = gluing_of("abs(-2)*x*(y^2 + abs(y - y - 1))/(y^2 + 1)");
  const auto& pieces = gluing.transitions()[0].pieces;
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_TRUE(pieces[0].nonnegative().empty());
  const RoundingGuard guard;
  PiecewiseValues<Interval> values(pieces);
  const std::array<Interval, 2> x{Interval(1), Interval(3)};
  std::array<Interval, 2> value;
  ASSERT_TRUE(values.value(x.data(), value.data()));
  EXPECT_EQ(value[0].lower(), 2);
  EXPECT_EQ(value[0].upper(), 2);
  const auto refusal = message_of<Rejection>([&] { (void)gluing_of("abs(-3)*x"); });
  EXPECT_TRUE(mentions(refusal, "atlas.inverse: the inverse of map is not the identity: coordinate 1 is not x"));
}

TEST(ChartGluing, refuses_an_inverse_that_is_wrong_on_one_side_of_a_fold) {
  const auto refusal = [](const std::string& map, const std::string& inverse) {
    return message_of<Rejection>([&] { (void)ChartGluing(folded(map, inverse)); });
  };
  EXPECT_EQ(refusal("x + abs(y)/3", "u - abs(v)/3"), "accepted");
  EXPECT_EQ(refusal("x + abs(y - 1)/3", "u - abs(v - 1)/3"), "accepted");
  // Both are u − v/3 above the line.
  EXPECT_TRUE(mentions(refusal("x + abs(y)/3", "u - v/3"), "atlas.inverse: the inverse of map is not the identity"));
  EXPECT_TRUE(mentions(refusal("x + y/3", "u - abs(v)/3"), "coordinate 1 is not x"));
  // A fold in another place.
  EXPECT_TRUE(mentions(refusal("x + abs(y)/3", "u - abs(v - 1/1000000)/3"), "atlas.inverse"));
  // What is folded onto a half-plane has no inverse.
  EXPECT_TRUE(mentions(refusal("x + abs(2*x)", "u/3"), "atlas.inverse"));
}

TEST(ChartGluing, refuses_folds_that_are_not_linear) {
  const auto refusal = [](const std::string& map) {
    return message_of<InputError>([&] { (void)ChartGluing(folded(map, "u")); });
  };
  EXPECT_TRUE(mentions(refusal("x + abs(x*y)"), "map, formula 1: not piecewise linear"));
  EXPECT_TRUE(mentions(refusal("x*y + abs(y)"), "map, formula 1: not piecewise linear"));
  EXPECT_TRUE(mentions(refusal("x + abs(1/y)"), "map, formula 1: not piecewise linear"));
  // A linear formula and one that is not.
  const auto both = message_of<InputError>([] {
    (void)ChartGluing(two_charts(Rational(2), Rational(1), {0, 1, {"x + abs(y)", "y^3"}, {"u", "v"}, {}}));
  });
  EXPECT_TRUE(mentions(both, "map: not piecewise linear"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
