#include "proofs/replay/enclosure.hpp"

#include <gtest/gtest.h>

namespace delcert::replay {
namespace DELCERT_THIS_FILE {

const std::vector<std::string> names{"x", "k"};

Side side(const char* lower, bool lower_open, const char* upper, bool upper_open) {
  Side result;
  if (lower != nullptr) result.lower = Number::read(lower);
  if (upper != nullptr) result.upper = Number::read(upper);
  result.lower_open = lower_open;
  result.upper_open = upper_open;
  return result;
}

const Side unit = side("0", false, "1", false);
const Side half_open = side("0", true, "1", false);
const Side from_one = side("1", false, nullptr, true);

std::optional<int> sign(const std::string& a, const std::string& b, const Side& x, const Side& k,
                        slong precision = 128) {
  return Encloser(names, {x, k}, precision).sign_of_difference(read_statement(a), read_statement(b));
}

TEST(ReplayEnclosures, tell_signs) {
  EXPECT_EQ(sign("x", "2", unit, from_one), -2);
  EXPECT_EQ(sign("x", "0", unit, from_one), 1);
  EXPECT_EQ(sign("x", "0", half_open, from_one), 2);
  EXPECT_EQ(sign("(- x x)", "0", side("1/2", false, "1/2", false), from_one), 0);
  EXPECT_EQ(sign("(^ (/ 2 x) (+ (* 4 (^ k 2)) 26))", "(^ 2 30)", half_open, from_one), 1);
  EXPECT_EQ(sign("(min x k)", "(max x k)", unit, from_one), -1);
  EXPECT_EQ(sign("(abs (- x 1/2))", "1/2", unit, from_one), -1);
  EXPECT_EQ(sign("x", "1/2", unit, from_one), std::nullopt);
}

TEST(ReplayEnclosures, tell_signs_by_monotonicity_and_without_quotients) {
  EXPECT_EQ(sign("(^ 2 k)", "(+ k 1)", unit, from_one), 1);
  EXPECT_EQ(sign("(^ 2 k)", "(+ k 1)", unit, side("2", false, nullptr, true)), 2);
  EXPECT_EQ(sign("(/ (log2 k) k)", "1", unit, side("2", false, nullptr, true)), -2);
  EXPECT_EQ(sign("(sqrt (+ 1 x))", "(+ 1 (/ x 2))", unit, from_one), -1);
  EXPECT_EQ(sign("(sqrt (+ 1 x))", "(+ 1 (/ x 2))", half_open, from_one), -2);
  EXPECT_EQ(sign("(- (^ 2 k) (* 3 k))", "0", unit, from_one), std::nullopt) << "negative for k = 1, positive for 4";
}

TEST(ReplayEnclosures, are_as_wide_as_the_precision_makes_them) {
  const Side three = side("3", false, "3", false);
  EXPECT_EQ(sign("(log2 k)", "(/ 159 100)", unit, three), -2);
  EXPECT_EQ(sign("(log2 k)", "(/ 159 100)", unit, three, 4), std::nullopt);
}

TEST(ReplayEnclosures, know_where_there_may_be_no_value) {
  const auto has_value = [](const std::string& term, const Side& x) {
    return Encloser(names, {x, from_one}, 128).has_value(read_statement(term));
  };
  EXPECT_FALSE(has_value("(/ 1 x)", unit));
  EXPECT_TRUE(has_value("(/ 1 x)", half_open));
  EXPECT_FALSE(has_value("(sqrt (- x 1))", unit));
  EXPECT_FALSE(has_value("(log2 x)", unit));
  EXPECT_FALSE(has_value("(^ x k)", unit));
  EXPECT_EQ(sign("(/ 1 x)", "0", unit, from_one), std::nullopt);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::replay
