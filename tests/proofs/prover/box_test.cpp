#include "proofs/prover/box.hpp"

#include <gtest/gtest.h>

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;

Box box(const std::string& range, bool is_squared = false) { return {box_side(parse_step_range(range), is_squared)}; }

Rational simplest(const std::string& range) { return simplest_in(box(range)[0]); }

TEST(Boxes, sides_of_integers_end_at_integers) {
  EXPECT_EQ(box_text(box("integer (1, 9/2]"), {"k"}), "k in integer [2, 4]");
  EXPECT_EQ(box_text(box("integer [1/2, infinity)"), {"k"}), "k in integer [1, infinity)");
  EXPECT_EQ(box_text(box("integer (1, 2]"), {"k"}), "k = 2");
  EXPECT_EQ(box_text(box("(1, 9/2]"), {"k"}), "k in (1, 9/2]");
}

TEST(Boxes, the_real_line_is_two) {
  const StepRange line = parse_step_range("(-infinity, infinity)");
  const StepRange unit = parse_step_range("[0, 1]");
  const auto boxes = boxes_of({line, unit, line}, {false, false, false});
  ASSERT_EQ(boxes.size(), 4U);
  EXPECT_EQ(box_text(boxes[0], {"x", "y", "z"}), "x in (-infinity, 0], y in [0, 1], z in (-infinity, 0]");
  EXPECT_EQ(box_text(boxes[3], {"x", "y", "z"}), "x in [0, infinity), y in [0, 1], z in [0, infinity)");
  EXPECT_EQ(boxes_of({unit}, {false}).size(), 1U);
  EXPECT_EQ(boxes_of({}, {}).size(), 1U);
}

TEST(Boxes, are_cut_without_a_gap_but_between_integers) {
  const Box real = box("(0, 3]");
  const CutBox parts = cut(real, middle_cut(real, 0));
  EXPECT_EQ(box_text(parts.lower, {"x"}), "x in (0, 3/2]");
  EXPECT_EQ(box_text(parts.upper, {"x"}), "x in [3/2, 3]");
  EXPECT_EQ(parts.lower_part_ends, ratio(1, 2));
  EXPECT_EQ(parts.upper_part_begins, ratio(1, 2));
  const Box integers = box("integer [1, infinity)");
  const CutBox cases = cut(integers, middle_cut(integers, 0));
  EXPECT_EQ(box_text(cases.lower, {"k"}), "k in integer [1, 2]");
  EXPECT_EQ(box_text(cases.upper, {"k"}), "k in integer [3, infinity)");
  EXPECT_LT(cases.lower_part_ends, cases.upper_part_begins);
  const CutBox single = cut(cases.lower, middle_cut(cases.lower, 0));
  EXPECT_TRUE(single.lower[0].is_point() && single.upper[0].is_point());
}

TEST(Boxes, ends_are_open_where_the_range_is) {
  const Box half_open = box("(0, 1]");
  const CutBox parts = cut(half_open, middle_cut(half_open, 0));
  EXPECT_TRUE(parts.lower[0].unit_open().lower);
  EXPECT_FALSE(parts.lower[0].unit_open().upper || parts.upper[0].unit_open().lower ||
               parts.upper[0].unit_open().upper);
  EXPECT_TRUE(box("[0, infinity)")[0].unit_open().upper);
}

TEST(Boxes, of_squares_have_roots_that_contain_them) {
  const BoxSide exact = box("[1, 4]", true)[0];
  EXPECT_EQ(*exact.map.lower, Rational(1));
  EXPECT_EQ(*exact.map.upper, Rational(2));
  EXPECT_FALSE(exact.map_open.lower || exact.map_open.upper);
  const BoxSide rounded = box("integer [2, 3]", true)[0];
  EXPECT_LT(square(*rounded.map.lower), Rational(2));
  EXPECT_GT(square(*rounded.map.upper), Rational(3));
  EXPECT_TRUE(rounded.map_open.lower && rounded.map_open.upper);
  const Box whole{rounded};
  const CutBox parts = cut(whole, middle_cut(whole, 0));
  EXPECT_GE(square(*rounded.map.at(parts.lower_part_ends)), Rational(2));
  EXPECT_LE(square(*rounded.map.at(parts.upper_part_begins)), Rational(3));
}

TEST(Boxes, the_simplest_number_has_the_least_denominator) {
  EXPECT_EQ(simplest("[-1, 1]"), Rational(0));
  EXPECT_EQ(simplest("(0, 1]"), Rational(1));
  EXPECT_EQ(simplest("(0, 1)"), ratio(1, 2));
  EXPECT_EQ(simplest("(1/3, 1/2)"), ratio(2, 5));
  EXPECT_EQ(simplest("[1/3, 1/2)"), ratio(1, 3));
  EXPECT_EQ(simplest("[314/100, 315/100]"), ratio(22, 7));
  EXPECT_EQ(simplest("(-1/2, -1/3)"), ratio(-2, 5));
  EXPECT_EQ(simplest("(7/2, infinity)"), Rational(4));
  EXPECT_EQ(simplest("(-infinity, -7/2)"), Rational(-4));
  EXPECT_EQ(simplest("integer [3, infinity)"), Rational(3));
}

TEST(Boxes, as_enclosures_contain_their_parameters) {
  const ParameterBox enclosures = parameter_box(box("(0, 1/3]"), PrecisionBits{64U});
  EXPECT_TRUE(enclosures.at(0).is_positive());
  EXPECT_GE(mpfr_cmp_q(enclosures[0].upper().raw(), ratio(1, 3).gmp()), 0);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
