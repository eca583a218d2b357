#include "kernel/number/verdict.hpp"

#include <gtest/gtest.h>

#include <array>
#include <type_traits>

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(!std::is_convertible_v<Verdict, bool>);
static_assert(!std::is_convertible_v<bool, Verdict>);
static_assert(!std::is_constructible_v<bool, Verdict>);

constexpr std::array<Verdict, 3> all = {Verdict::refuted, Verdict::undecided, Verdict::proved};

/// The verdict about a connective of two statements, by trying all truth values that they may have.
template <class Connective>
Verdict by_cases(Verdict a, Verdict b, const Connective& connective) {
  bool may_be_true = false;
  bool may_be_false = false;
  for (const bool x : {false, true}) {
    if (!is_undecided(a) && x != is_proved(a)) continue;
    for (const bool y : {false, true}) {
      if (!is_undecided(b) && y != is_proved(b)) continue;
      (connective(x, y) ? may_be_true : may_be_false) = true;
    }
  }
  return !may_be_false ? Verdict::proved : !may_be_true ? Verdict::refuted : Verdict::undecided;
}

TEST(Verdict, connectives_say_what_holds_for_all_truth_values_that_are_left_open) {
  for (const Verdict a : all) {
    EXPECT_EQ(negation(a), by_cases(a, a, [](bool x, bool) { return !x; }));
    for (const Verdict b : all) {
      EXPECT_EQ(conjunction(a, b), by_cases(a, b, [](bool x, bool y) { return x && y; }));
      EXPECT_EQ(disjunction(a, b), by_cases(a, b, [](bool x, bool y) { return x || y; }));
    }
  }
}

TEST(Verdict, exactly_one_of_the_three_questions_is_answered_yes) {
  for (const Verdict a : all) EXPECT_EQ(int{is_proved(a)} + int{is_refuted(a)} + int{is_undecided(a)}, 1);
  EXPECT_TRUE(is_proved(Verdict::proved) && is_refuted(Verdict::refuted) && is_undecided(Verdict::undecided));
}

TEST(Verdict, of_a_truth_value_is_never_undecided) {
  EXPECT_EQ(verdict_of(true), Verdict::proved);
  EXPECT_EQ(verdict_of(false), Verdict::refuted);
}

TEST(Verdict, has_a_name) {
  EXPECT_EQ(name_of(Verdict::proved), "proved");
  EXPECT_EQ(name_of(Verdict::refuted), "refuted");
  EXPECT_EQ(name_of(Verdict::undecided), "undecided");
}

TEST(Verdict, starts_undecided) { EXPECT_EQ(Verdict{}, Verdict::undecided); }

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
