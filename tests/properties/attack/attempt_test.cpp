#include "properties/attack/attempt.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::claim_about_simplices;
using test::right_claim;
using test::triangle_bindings;
using test::wrong_claim;

const Rational half = Rational(1) / Rational(2);

TEST(Attempt, a_conclusion_holds_is_violated_and_its_ratio_encloses_the_exact_one) {
  // The right triangle (0, 0), (1, 0), (0, 1) has circumradius √2/2 and longest edge √2.
  const Attempt held = attempt(wrong_claim(), triangle_bindings(0, 1));
  EXPECT_EQ(held.hypotheses, Verdict::proved);
  ASSERT_EQ(held.conclusions.size(), 1U);
  EXPECT_EQ(held.conclusions[0].verdict, Verdict::proved);
  EXPECT_LE(held.conclusions[0].ratio->lower, 0.5);
  EXPECT_GE(held.conclusions[0].ratio->upper, 0.5);
  EXPECT_LE(held.conclusions[0].ratio->upper - held.conclusions[0].ratio->lower, 0x1p-20);
  const Attempt violated = attempt(wrong_claim(), triangle_bindings(half, Rational(1) / Rational(100)));
  EXPECT_EQ(violated.conclusions.at(0).verdict, Verdict::refuted);
  EXPECT_GT(violated.conclusions[0].ratio->lower, 1);
}

TEST(Attempt, where_a_hypothesis_fails_nothing_is_said_of_the_conclusions) {
  const Claim claim = claim_about_simplices("a", "given = [\"k <= 1\"]\n[[show]]\nclaim = \"k <= 1\"\n");
  const Attempt result = attempt(claim, triangle_bindings(0, 1));
  EXPECT_EQ(result.hypotheses, Verdict::refuted);
  EXPECT_TRUE(result.conclusions.empty());
}

TEST(Attempt, a_vertex_that_the_simplex_has_not_is_an_input_error) {
  const Claim claim = claim_about_simplices("a", "[[show]]\nclaim = \"altitude(s, 7) > 0\"\n");
  EXPECT_THROW((void)attempt(claim, triangle_bindings(0, 1)), InputError);
}

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

TEST(Attempt, drawn_parameters_are_in_their_range_and_reach_the_end_that_belongs_to_it) {
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

TEST(Attempt, the_names_of_a_claim_are_those_of_its_class_and_its_parameters_in_their_ranges) {
  const Claim claim = right_claim();
  Bindings bindings = triangle_bindings(0, 1);
  EXPECT_THROW(require_names_of(claim, bindings), InputError);
  bindings["eta"] = Rational(1);
  EXPECT_NO_THROW(require_names_of(claim, bindings));
  for (const Rational& outside : {Rational(0), Rational(-1), Rational(1) + Rational::power_of_two(-100)}) {
    bindings["eta"] = outside;
    EXPECT_THROW(require_names_of(claim, bindings), InputError);
  }
  bindings["eta"] = half;
  bindings["theta"] = half;
  EXPECT_THROW(require_names_of(claim, bindings), InputError);
}

TEST(Attempt, twins_have_one_conclusion_moved_or_one_hypothesis_less) {
  const Claim claim = right_claim();
  const Claim moved = twin_of_conclusion(claim, 0);
  EXPECT_EQ(moved.name, "right/radius-twin");
  EXPECT_EQ(moved.conclusions.at(0).text, "eta*circumradius(s) <= longest_edge(s)/4");
  EXPECT_EQ(moved.hypotheses.size(), 1U);
  const Claim dropped = twin_of_hypothesis(claim, 0);
  EXPECT_EQ(dropped.name, "right/without-small");
  EXPECT_TRUE(dropped.hypotheses.empty());
  EXPECT_EQ(dropped.conclusions.at(0).text, claim.conclusions.at(0).text);
}

TEST(Attempt, a_strict_statement_is_refuted_exactly_where_there_is_equality) {
  const Claim claim = claim_about_simplices(
      "a",
      "[[show]]\nclaim = \"2*circumradius(s) >= longest_edge(s) and (forall f in faces(s): thickness(f) <= 1)\"\n");
  const Bindings right = triangle_bindings(0, 1);
  const Bindings acute = triangle_bindings(half, 1);
  const auto strict = made_strict(claim.conclusions[0].formula);
  Scene equality(right);
  EXPECT_EQ(decide_statement(*claim.conclusions[0].formula, equality), Verdict::proved);
  EXPECT_EQ(decide_statement(*strict, equality), Verdict::refuted);
  // Vertices and edges have thickness 1: without them the acute triangle has no equality.
  const Claim radius = claim_about_simplices("b", "[[show]]\nclaim = \"2*circumradius(s) >= longest_edge(s)\"\n");
  Scene inequality(acute);
  EXPECT_EQ(decide_statement(*made_strict(radius.conclusions[0].formula), inequality), Verdict::proved);
}

TEST(Attempt, claims_are_found_by_name_and_by_file_and_others_get_a_suggestion) {
  ASSERT_FALSE(builtin_claim_list().empty());
  const std::string name = builtin_claim_list().front().name;
  EXPECT_EQ(find_claim(name).name, name);
  EXPECT_THROW((void)find_claim("no/such/file.toml"), InputError);
  EXPECT_THROW((void)find_claim(std::string(5000, 'a')), InputError);
  EXPECT_THROW((void)find_claim(""), InputError);
  try {
    (void)find_claim(name + "x");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean " + name + "?"), std::string::npos) << error.what();
  }
}

TEST(AttemptedRatio, is_that_of_the_attempt_where_it_is_above_what_is_known) {
  const Claim claim = test::wrong_claim();
  const Bindings bindings = test::triangle_bindings(Rational(1) / Rational(2), Rational(1) / Rational(5));
  const auto sharp = attempt(claim, bindings).conclusions.at(0).ratio.value();
  for (const double known : {-1.0, 0.5}) {
    const auto ratio = attempted_ratio(claim, 0, bindings, known);
    ASSERT_TRUE(ratio.has_value());
    EXPECT_EQ(ratio->lower, sharp.lower);
    EXPECT_EQ(ratio->upper, sharp.upper);
  }
  EXPECT_LE(attempted_ratio(claim, 0, bindings, 10).value().upper, 10);
}

TEST(AttemptedRatio, is_nothing_where_a_hypothesis_fails_or_no_ratio_is_defined) {
  const Claim never = test::claim_about_simplices("a", "given = [\"k = 1\"]\n[[show]]\nclaim = \"k <= 1\"\n");
  EXPECT_FALSE(attempted_ratio(never, 0, test::triangle_bindings(0, 1), -1).has_value());
  const Claim no_ratio = test::claim_about_simplices("a", "[[show]]\nclaim = \"is_nondegenerate(s)\"\n");
  EXPECT_FALSE(attempted_ratio(no_ratio, 0, test::triangle_bindings(0, 1), -1).has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
