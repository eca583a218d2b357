#include "properties/attack/hypothesis_limits.hpp"

#include <gtest/gtest.h>

#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::claim_about_simplices;

TEST(HypothesisLimits, the_least_of_the_limits_that_are_known_either_way_round_and_inside_conjunctions) {
  const Claim claim = claim_about_simplices(
      "a",
      "forall = { x = \"[0, 8]\", y = \"[0, 8]\" }\n"
      "given = [\"x <= 3 and 2 >= x\", \"x < y\", \"x >= 0\", \"not (x <= 1)\"]\n[[show]]\nclaim = \"x <= 3\"\n");
  const HypothesisLimits limits(claim);
  EXPECT_TRUE(limits.most("x", {}, true) == Rational(2));
  const auto strict = limits.most("x", {{"y", Rational(1)}}, true);
  EXPECT_TRUE(*strict < Rational(1) && Rational(1) - *strict < Rational::power_of_two(-50));
  EXPECT_FALSE(limits.most("y", {}, true).has_value());
}

TEST(HypothesisLimits, an_irrational_limit_is_met_from_below_and_nearly) {
  const Claim claim = claim_about_simplices(
      "a", "forall = { x = \"[0, 8]\" }\ngiven = [\"x <= sqrt(2)\"]\n[[show]]\nclaim = \"x <= 3\"\n");
  for (const bool exact : {false, true}) {
    const auto most = HypothesisLimits(claim).most("x", {}, exact);
    ASSERT_TRUE(most.has_value());
    EXPECT_TRUE(square(*most) < Rational(2));
    EXPECT_TRUE(square(*most * (Rational(1) + Rational::power_of_two(-28))) > Rational(2));
  }
}

TEST(HypothesisLimits, a_limit_without_a_value_is_zero) {
  const Claim claim = claim_about_simplices(
      "a", "forall = { x = \"[0, 8]\" }\ngiven = [\"x <= 1/(k - k)\"]\n[[show]]\nclaim = \"x <= 3\"\n");
  EXPECT_TRUE(HypothesisLimits(claim).most("x", {{"k", 2L}}, true) == Rational(0));
}

TEST(DrawInstance, drawn_parameters_are_in_their_range_and_reach_the_end_that_belongs_to_it) {
  const Claim claim = claim_about_simplices(
      "a",
      "forall = { x = \"(0, 1]\", y = \"[-2, 3)\" }\n[[show]]\nclaim = \"x > 0 and x <= 1 and y >= -2 and y < 3\"\n");
  const HypothesisLimits limits(claim);
  int upper = 0;
  int lower = 0;
  for (std::uint64_t number = 0; number < 300; ++number) {
    RandomChoices choices(1, 1, number);
    const auto instance = draw_instance(claim, limits, {1, 1}, choices);
    if (!instance) continue;
    EXPECT_EQ(attempt(claim, instance->bindings).conclusions.at(0).verdict, Verdict::proved);
    EXPECT_NO_THROW(require_names_of(claim, instance->bindings));
    upper += std::get<Rational>(instance->bindings.at("x")) == Rational(1) ? 1 : 0;
    lower += std::get<Rational>(instance->bindings.at("y")) == Rational(-2) ? 1 : 0;
  }
  EXPECT_GT(upper, 30);
  EXPECT_GT(lower, 30);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
