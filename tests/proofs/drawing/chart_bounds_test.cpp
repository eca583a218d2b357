#include "proofs/drawing/chart_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/number/rounding_guard.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

constexpr double infinity = std::numeric_limits<double>::infinity();

SymmetricMatrix<Interval> cartesian() {
  SymmetricMatrix<Interval> result(2);
  for (std::size_t row = 0; row < 2; ++row) {
    for (std::size_t column = 0; column <= row; ++column) result(row, column) = Interval(row == column ? 1 : 0);
  }
  return result;
}

/// A right triangle with legs 6 and 8: the circumcentre is (3, 4), the radius 5, the thickness 4.8/20.
ShownSimplex right_triangle() {
  const RoundingGuard guard;
  return {{{Interval(0), Interval(0)}, {Interval(6), Interval(0)}, {Interval(0), Interval(8)}},
          {{Interval(3), Interval(11)}, {Interval(-6), Interval(4)}}};
}

void expect_encloses(const std::optional<Interval>& interval, double value) {
  ASSERT_TRUE(interval.has_value());
  EXPECT_LE(interval->lower(), value);
  EXPECT_GE(interval->upper(), value);
  EXPECT_LT(interval->upper() - interval->lower(), 1e-12);
}

// Neither inlined nor specialised: it switches the rounding mode.
[[gnu::noipa]] ChartMeasures measured(const ShownSimplex& shown) {
  const RoundingGuard guard;
  return measures_in_chart(shown, cartesian(), Interval(2));
}

TEST(ChartBounds, enclose_what_is_known_of_a_right_triangle) {
  const ChartMeasures seen = measured(right_triangle());
  expect_encloses(seen.protection, 1);  // (7 − 5)/2
  expect_encloses(seen.thickness, 0.24);
  expect_encloses(seen.circumradius, 2.5);
}

TEST(ChartBounds, count_on_points_where_the_chart_does_not_show_all) {
  ShownSimplex shown = right_triangle();
  // |(3, 4)| = 5: of what is 11 from the origin it is known that it is 6 from the centre.
  shown.complete_radius = 11;
  const ChartMeasures seen = measured(shown);
  EXPECT_LE(seen.protection->lower(), 0.5);
  EXPECT_NEAR(seen.protection->lower(), 0.5, 1e-12);
  EXPECT_GE(seen.protection->upper(), 1);
  shown.complete_radius = 13;
  expect_encloses(measured(shown).protection, 1);
  shown.others.clear();
  EXPECT_FALSE(measured(shown).protection.has_value());
}

TEST(ChartBounds, are_absent_where_a_simplex_is_degenerate) {
  ShownSimplex shown = right_triangle();
  shown.vertices[2] = {Interval(3), Interval(0)};
  const ChartMeasures seen = measured(shown);
  EXPECT_FALSE(seen.circumradius.has_value());
  EXPECT_FALSE(seen.protection.has_value());
}

TEST(ChartBounds, of_several_charts_are_of_the_least_or_of_the_greatest) {
  SimplexBounds bounds = unmeasured(2);
  EXPECT_TRUE(std::isnan(bounds.thickness.lower[0]));
  const auto between = [](double a, double b) { return std::optional(Interval::between(a, b)); };
  add({between(1, 3), between(1, 3), between(1, 3)}, 1, bounds);
  add({between(2, 4), between(0.5, 4), between(2, 4)}, 1, bounds);
  EXPECT_EQ(bounds.protection.lower[1], 1);
  EXPECT_EQ(bounds.protection.upper[1], 3);
  EXPECT_EQ(bounds.thickness.lower[1], 0.5);
  EXPECT_EQ(bounds.thickness.upper[1], 3);
  EXPECT_EQ(bounds.circumradius.lower[1], 2);
  EXPECT_EQ(bounds.circumradius.upper[1], 4);
  // What one chart cannot tell, none can.
  add({}, 1, bounds);
  add({between(1, 3), between(1, 3), between(1, 3)}, 1, bounds);
  EXPECT_EQ(bounds.protection.lower[1], -infinity);
  EXPECT_EQ(bounds.thickness.lower[1], 0);
  EXPECT_EQ(bounds.circumradius.lower[1], 0);
  EXPECT_EQ(bounds.circumradius.upper[1], infinity);
  EXPECT_TRUE(std::isnan(bounds.thickness.lower[0]));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
