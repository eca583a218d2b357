#include "kernel/manifold/gluing/piecewise_cells.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/plain_formula.hpp"
#include "kernel/manifold/gluing/chart_gluing.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/gluing/atlas_samples.hpp"
#include "tests/support/contains.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// (x, y) goes to (x + |y|/3, y), in squares of half-width 2.
ChartGluing fold(const std::vector<std::string>& where = {}) {
  return ChartGluing(two_charts(Rational(2), Rational(1), {0, 1, {"x + abs(y)/3", "y"}, {"u - abs(v)/3", "v"}, where}));
}

Cell cell(double x0, double x1, double y0, double y1) {
  return {Interval::between(x0, x1), Interval::between(y0, y1), Interval(0)};
}

TEST(PiecewiseCells, encloses_images_across_a_fold) {
  const ChartGluing gluing = fold();
  const RoundingGuard guard;
  PiecewiseCells map(gluing.transitions()[0].pieces);
  const MapOnCell across = map.on(cell(0, 0.5, -0.375, 0.75));
  EXPECT_TRUE(across.is_regular);
  EXPECT_FALSE(across.is_excluded);
  for (const auto& x : {ratio(0, 1), ratio(1, 2), ratio(5, 8), ratio(3, 4)}) EXPECT_TRUE(contains(across.image[0], x));
  EXPECT_TRUE(contains(across.image[1], ratio(-3, 8)));
  // On one side there is one piece.
  const MapOnCell above = map.on(cell(0, 0.5, 0.375, 0.75));
  EXPECT_FALSE(contains(above.image[0], ratio(0, 1)));
  EXPECT_TRUE(contains(above.image[0], ratio(1, 8)));
  EXPECT_TRUE(map.on(0, cell(0, 0.5, 0.375, 0.75)).is_here);
  EXPECT_TRUE(map.on(1, cell(0, 0.5, 0.375, 0.75)).is_elsewhere);
  EXPECT_FALSE(map.on(1, cell(0, 0.5, -0.375, 0.75)).is_elsewhere);
}

TEST(PiecewiseCells, excludes_what_all_pieces_exclude) {
  const ChartGluing gluing = fold();
  const RoundingGuard guard;
  PiecewiseCells map(gluing.transitions()[0].pieces);
  EXPECT_TRUE(map.on(cell(1.75, 2, 1.5, 2)).is_excluded);
  EXPECT_TRUE(map.on(cell(1.75, 2, -2, -1.5)).is_excluded);
  EXPECT_FALSE(map.on(cell(1.75, 2, -0.125, 0.125)).is_excluded);
  // Conditions hold on the one side only.
  const ChartGluing half = fold({"y - 1/2"});
  PiecewiseCells cut(half.transitions()[0].pieces);
  EXPECT_TRUE(cut.on(cell(0, 0.5, -0.375, 0.375)).is_excluded);
  EXPECT_TRUE(cut.on(cell(0, 0.5, 0.75, 1)).is_regular);
  EXPECT_FALSE(cut.on(cell(0, 0.5, 0.375, 1)).is_regular);
}

/// The identity where the first polynomial is not negative, on the domain where the second one is above 0.
CellMap identity_where(const std::string& not_negative, const std::string& positive) {
  const std::vector<std::string> names{"x", "y"};
  const auto function = [&](const std::string& text) {
    return *rational_function_of(*parse_plain_formula(text, names), names, CellMap::ring(2));
  };
  return {
      {function("x"), function("y")},    Sides(2, {Rational(-2), Rational(2)}), {function(positive).numerator}, {}, {},
      {function(not_negative).numerator}};
}

TEST(PiecewiseCells, are_regular_or_excluded_only_if_all_pieces_are_in_whichever_order) {
  // Below y = 0 the domain is all of the square, above it only a part.
  const CellMap whole = identity_where("-y", "x + 3");
  const CellMap part = identity_where("y", "x - 1");
  const RoundingGuard guard;
  const std::vector<CellMap> one_order{whole, part};
  const std::vector<CellMap> other_order{part, whole};
  for (const auto& pieces : {one_order, other_order}) {
    PiecewiseCells map(pieces);
    const MapOnCell across = map.on(cell(0, 0.5, -0.25, 0.25));
    EXPECT_FALSE(across.is_regular);
    EXPECT_FALSE(across.is_excluded);
    EXPECT_TRUE(map.on(cell(0, 0.5, 0.25, 0.5)).is_excluded);
    EXPECT_TRUE(map.on(cell(0, 0.5, -0.5, -0.25)).is_regular);
    EXPECT_TRUE(map.on(cell(1.25, 1.5, -0.25, 0.25)).is_regular);
  }
}

TEST(PiecewiseCells, knows_unrelated_cells) {
  const ChartGluing gluing = fold();
  const RoundingGuard guard;
  PiecewiseCells map(gluing.transitions()[0].pieces);
  EXPECT_TRUE(map.are_unrelated(cell(0, 0.5, -0.375, 0.375), cell(1, 1.5, -0.375, 0.375)));
  EXPECT_FALSE(map.are_unrelated(cell(0, 0.5, -0.375, 0.375), cell(0.5, 1.5, -0.375, 0.375)));
  // What the other piece would do does not count.
  EXPECT_TRUE(map.are_unrelated(cell(1, 1.125, 0.75, 1), cell(0.5, 0.875, 0.75, 1)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
