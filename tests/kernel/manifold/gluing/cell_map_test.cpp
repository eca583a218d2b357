#include "kernel/manifold/gluing/cell_map.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/plain_formula.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "tests/support/contains.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const std::vector<std::string> variables{"x", "y"};

RationalFunction function(const std::string& text) {
  return *rational_function_of(*parse_plain_formula(text, variables), variables, CellMap::ring(2));
}

CellMap map_of(const std::vector<std::string>& formulas, const std::vector<std::string>& positive,
               const std::vector<std::string>& nonzero, bool with_formulas = true) {
  std::vector<RationalFunction> map;
  for (const auto& text : formulas) map.push_back(function(text));
  std::vector<Polynomial> above;
  for (const auto& text : positive) above.push_back(function(text).numerator);
  std::vector<Polynomial> other;
  for (const auto& text : nonzero) other.push_back(function(text).numerator);
  std::optional<FormulaMap> given;
  if (with_formulas) given.emplace(variables, formulas);
  return {map, Sides(2, {Rational(-2), Rational(2)}), above, other, given};
}

const std::vector<std::string> inversion{"x/(x^2 + y^2)", "y/(x^2 + y^2)"};

Cell cell(double x0, double x1, double y0, double y1) {
  return {Interval::between(x0, x1), Interval::between(y0, y1), Interval(0)};
}

TEST(CellMap, encloses_the_image_of_a_cell) {
  for (const bool with_formulas : {true, false}) {
    const CellMap map = map_of(inversion, {}, {"x^2 + y^2"}, with_formulas);
    const RoundingGuard guard;
    CellMapEvaluation evaluation(map);
    const MapOnCell found = evaluation.on(cell(0.5, 0.625, -0.25, -0.125));
    ASSERT_TRUE(found.has_image);
    EXPECT_TRUE(found.is_regular);
    EXPECT_FALSE(found.is_excluded);
    for (const auto& x : {ratio(1, 2), ratio(5, 8), ratio(9, 16)}) {
      for (const auto& y : {ratio(-1, 4), ratio(-1, 8), ratio(-3, 16)}) {
        EXPECT_TRUE(contains(found.image[0], *value_at(map.map()[0], {x, y})));
        EXPECT_TRUE(contains(found.image[1], *value_at(map.map()[1], {x, y})));
      }
    }
    EXPECT_FALSE(contains(found.image[1], ratio(0, 1)));
    EXPECT_LT(found.image[0].upper() - found.image[0].lower(), 1.3);
  }
}

TEST(CellMap, knows_where_a_map_misses_its_box) {
  const CellMap map = map_of(inversion, {}, {"x^2 + y^2"});
  const RoundingGuard guard;
  CellMapEvaluation evaluation(map);
  // By the image; by the sum of squares, where there is no image.
  EXPECT_TRUE(evaluation.on(cell(0.25, 0.3125, -0.125, 0.125)).is_excluded);
  const MapOnCell at_pole = evaluation.on(cell(-0.125, 0.125, -0.125, 0.25));
  EXPECT_FALSE(at_pole.has_image);
  EXPECT_TRUE(at_pole.is_excluded);
  EXPECT_FALSE(at_pole.is_regular);
  EXPECT_FALSE(evaluation.on(cell(-1, 1, -1, 1)).is_excluded);
  EXPECT_FALSE(evaluation.on(cell(0.375, 0.625, -0.125, 0.125)).is_excluded);
}

/// There the squares add up to more than 1, and to less than the dimension.
TEST(CellMap, does_not_miss_the_corners_of_its_box) {
  const CellMap map = map_of({"x", "y"}, {}, {});
  const RoundingGuard guard;
  CellMapEvaluation evaluation(map);
  EXPECT_FALSE(evaluation.on(cell(1.75, 1.875, -1.875, -1.75)).is_excluded);
  EXPECT_TRUE(evaluation.on(cell(2.0625, 2.125, -1.875, -1.75)).is_excluded);
}

TEST(CellMap, knows_poles_by_one_coordinate) {
  const CellMap map = map_of({"1/x", "y/x"}, {}, {"x"});
  const RoundingGuard guard;
  CellMapEvaluation evaluation(map);
  EXPECT_TRUE(evaluation.on(cell(-0.25, 0.25, -4, 4)).is_excluded);
  EXPECT_FALSE(evaluation.on(cell(-0.75, 0.25, -4, 4)).is_excluded);
  EXPECT_TRUE(evaluation.on(cell(0.75, 1, -0.5, 0.5)).is_regular);
}

TEST(CellMap, knows_what_conditions_exclude) {
  const CellMap map = map_of({"x", "y"}, {"x - 1/4"}, {"y - 1"});
  const RoundingGuard guard;
  CellMapEvaluation evaluation(map);
  const MapOnCell above = evaluation.on(cell(0.5, 1, 0, 0.5));
  EXPECT_TRUE(above.is_positive);
  EXPECT_TRUE(above.is_regular);
  EXPECT_TRUE(evaluation.on(cell(0, 0.25, 0, 0.5)).is_excluded);
  const MapOnCell across = evaluation.on(cell(0, 0.5, 0, 0.5));
  EXPECT_FALSE(across.is_excluded);
  EXPECT_FALSE(across.is_positive);
  EXPECT_FALSE(across.is_regular);
  // What may not vanish.
  const MapOnCell vanishing = evaluation.on(cell(0.5, 1, 0.5, 1.5));
  EXPECT_TRUE(vanishing.is_positive);
  EXPECT_FALSE(vanishing.is_regular);
}

TEST(CellMap, is_tight_on_small_cells) {
  const CellMap map = map_of({"x*(x - 1) + x - x^2", "y"}, {}, {});
  const RoundingGuard guard;
  CellMapEvaluation evaluation(map);
  // The first coordinate is 0.
  const MapOnCell found = evaluation.on(cell(0.5, 0.75, 0, 1));
  EXPECT_EQ(found.image[0].lower(), 0);
  EXPECT_EQ(found.image[0].upper(), 0);
}

TEST(CellMap, compares_places_with_boxes) {
  const Sides box{{ratio(1, 3), Rational(2)}, {Rational(0), Rational(1)}};
  const RoundingGuard guard;
  const Cell whole = cell_around(box);
  EXPECT_LT(Rational::exactly(whole[0].lower()), ratio(1, 3));
  EXPECT_EQ(whole[0].upper(), 2);
  EXPECT_FALSE(is_inside(whole, box));
  EXPECT_TRUE(is_inside(cell(0.5, 2, 0, 1), box));
  EXPECT_FALSE(is_inside(cell(0.5, 2, 0, 1.0625), box));
  EXPECT_FALSE(is_outside(cell(0.5, 2, 1, 2), box));
  EXPECT_TRUE(is_outside(cell(0.5, 2, 1.0625, 2), box));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
