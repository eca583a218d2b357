#include "proofs/prover/slack.hpp"

#include <gtest/gtest.h>

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;
using test::step;

/// The best value lies between the two ends, with which the step is proved and refuted.
void expect_best(const Slack& slack, const Step& of, const Rational& best) {
  ASSERT_TRUE(slack.proved && slack.refuted);
  EXPECT_TRUE(slack.is_sharp());
  EXPECT_LE(minimum(*slack.proved, *slack.refuted), best);
  EXPECT_GE(maximum(*slack.proved, *slack.refuted), best);
  auto constants = of.constants;
  constants[slack.constant] = *slack.proved;
  EXPECT_EQ(prove(of, constants).verdict, Verdict::proved);
  constants[slack.constant] = *slack.refuted;
  EXPECT_EQ(decide_at(of, constants, slack.counterexample), Verdict::refuted);
}

TEST(Slack, of_a_constant_that_is_the_best) {
  const Step tight = step("forall = { xi = '(0, 1/4]' }\nconstants = { c = '4/5' }\nclaim = '1/(1 + xi) >= c'");
  const Slack slack = slack_of(tight, "c");
  expect_best(slack, tight, ratio(4, 5));
  EXPECT_EQ(slack.stated, ratio(4, 5));
}

TEST(Slack, of_constants_with_room_in_either_direction) {
  const Step above = step("forall = { x = '[0, 1]' }\nconstants = { c = '3' }\nclaim = 'x*(1 - x) <= c'");
  expect_best(slack_of(above, "c"), above, ratio(1, 4));
  const Step below = step("forall = { x = '[0, 1]' }\nconstants = { c = '-7' }\nclaim = 'x*(x - 1) >= c'");
  expect_best(slack_of(below, "c"), below, ratio(-1, 4));
  const Step far = step("forall = { x = '[0, 1]' }\nconstants = { c = '2000000' }\nclaim = 'x + 1 <= c'");
  expect_best(slack_of(far, "c"), far, Rational(2));
  const Step zero = step("forall = { x = '[0, 1]' }\nconstants = { c = '0' }\nclaim = 'x + 1/3 >= c'");
  expect_best(slack_of(zero, "c"), zero, ratio(1, 3));
}

TEST(Slack, of_a_step_that_is_false_says_with_what_it_is_true) {
  const Step wrong = step("forall = { x = '[0, 1]' }\nconstants = { c = '1/5' }\nclaim = 'x*(1 - x) <= c'");
  expect_best(slack_of(wrong, "c"), wrong, ratio(1, 4));
}

TEST(Slack, of_one_constant_leaves_the_others_alone) {
  const Step two = step("forall = { x = '[0, 1]' }\nconstants = { a = '3', b = '1' }\nclaim = 'a*x + b <= 5'");
  expect_best(slack_of(two, "a"), two, Rational(4));
  expect_best(slack_of(two, "b"), two, Rational(2));
}

TEST(Slack, of_a_constant_that_does_not_matter_is_nothing) {
  const Step any = step("forall = { x = '[0, 1]' }\nconstants = { c = '3' }\nclaim = 'x^2 + c^2 >= 0'");
  const Slack slack = slack_of(any, "c");
  EXPECT_TRUE(slack.proved);
  EXPECT_FALSE(slack.refuted || slack.is_sharp());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
