#include "kernel/formula/map_piece.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/plain_formula.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const RingPointer ring = std::make_shared<const PolynomialRing>(std::vector<std::string>{"x0", "x1"});
const std::vector<std::string> variables{"u", "v"};

std::optional<std::vector<MapPiece>> pieces(const std::vector<std::string>& texts) {
  std::vector<ExpressionPointer> formulas;
  for (const std::string& text : texts)
    formulas.push_back(parse_plain_formula(text, variables, AbsoluteValues::allowed));
  return pieces_of(formulas, variables, ring);
}

Polynomial polynomial(const std::string& text) {
  return rational_function_of(*parse_plain_formula(text, variables), variables, ring)->numerator;
}

bool may_be(const std::vector<std::string>& texts) {
  std::vector<Polynomial> polynomials;
  for (const std::string& text : texts) polynomials.push_back(polynomial(text));
  return may_be_positive_together(polynomials);
}

TEST(MapPiece, is_one_of_a_rational_map) {
  const auto found = pieces({"u/v", "1/v"});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 1U);
  EXPECT_TRUE(found->front().nonnegative.empty());
}

TEST(MapPiece, is_one_of_several_for_each_pattern_of_signs) {
  EXPECT_EQ(pieces({"u + abs(v)", "v"})->size(), 2U);
  EXPECT_EQ(pieces({"u + abs(v)", "v + abs(u)"})->size(), 4U);
  // Two parallel lines: three strips. Values of numbers do not count.
  EXPECT_EQ(pieces({"u + abs(v) + abs(v - 1)", "v"})->size(), 3U);
  EXPECT_EQ(pieces({"u + abs(1 - 3)", "v"})->size(), 1U);
  EXPECT_EQ(pieces({"u + abs(1 - 3)", "v"})->front().map[0].numerator.text(), "x0 + 2");
  // The greater one of u and v, and of that and 0: three regions that meet in a point.
  EXPECT_EQ(pieces({"abs((u + v + abs(u - v))/2)", "v"})->size(), 4U);
}

TEST(MapPiece, is_none_of_what_is_not_linear) {
  EXPECT_FALSE(pieces({"u + abs(u*v)", "v"}));
  EXPECT_FALSE(pieces({"u + abs(v)", "v^2"}));
  EXPECT_FALSE(pieces({"u/v + abs(v)", "v"}));
  EXPECT_FALSE(pieces({"sin(u)", "v"}));
}

TEST(MapPiece, is_where_conditions_hold_together) {
  EXPECT_TRUE(may_be({}));
  EXPECT_TRUE(may_be({"u", "v", "1 - u - v"}));
  EXPECT_FALSE(may_be({"u", "v", "-u - v"}));
  EXPECT_FALSE(may_be({"u", "-u"}));
  EXPECT_FALSE(may_be({"u - 1/1000000", "-u"}));
  EXPECT_TRUE(may_be({"u + 1/1000000", "-u"}));
  EXPECT_FALSE(may_be({"-1"}));
  EXPECT_FALSE(may_be({"u - u"}));
  // What is not linear is not looked at.
  EXPECT_TRUE(may_be({"-u^2"}));
  EXPECT_FALSE(may_be({"u*v", "u", "-u"}));
}

TEST(MapPiece, composes_with_others_where_regions_meet) {
  const auto fold = *pieces({"u + abs(v)/3", "v"});
  const auto back = *pieces({"u - abs(v)/3", "v"});
  const auto both = *composed(back, fold);
  ASSERT_EQ(both.size(), 2U);
  for (const MapPiece& piece : both) EXPECT_TRUE(is_identity(piece.map));
  const auto twice = *composed(fold, fold);
  ASSERT_EQ(twice.size(), 2U);
  for (const MapPiece& piece : twice) EXPECT_FALSE(is_identity(piece.map));
  EXPECT_TRUE(are_same(twice[0].map, pieces({"u + 2*v/3", "v"})->front().map));
  EXPECT_FALSE(composed(*pieces({"1/(u - v)", "v"}), *pieces({"u", "u"})));
}

TEST(MapPiece, carries_conditions_back) {
  const auto inversion = *pieces({"1/u", "v"});
  // 1/u − 1 > 0, times the square of u.
  const Polynomial sign = sign_after(polynomial("u - 1"), inversion.front().map);
  EXPECT_GT(sign.at({ratio(1, 2), Rational(0)}), Rational(0));
  EXPECT_LT(sign.at({Rational(2), Rational(0)}), Rational(0));
  EXPECT_LT(sign.at({Rational(-2), Rational(0)}), Rational(0));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
