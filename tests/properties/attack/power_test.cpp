#include "properties/attack/power.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "kernel/formula/formula_text.hpp"
#include "properties/attack/attempt.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::claim_about_simplices;

Claim claim_showing(const std::string& text, const std::string& given = "") {
  return claim_about_simplices("a", given + "[[show]]\nname = \"part\"\nclaim = \"" + text + "\"\n");
}

Claim claim_about_pairs(const std::string& given, const std::string& text) {
  return parse_claim("name = \"pairs\"\ninstance = \"simplex-pair\"\ngiven = [\"" + given +
                         "\"]\n[[show]]\nname = \"part\"\nclaim = \"" + text + "\"\n",
                     "pairs.toml", full_vocabulary(), all_signatures());
}

Power power_at(const Claim& claim, const std::string& place, const Shape& shape, std::uint64_t evaluations,
               PlaceKind kind = PlaceKind::summand) {
  for (const PowerPlace& each : power_places(claim)) {
    if (each.place.text == place && each.place.kind == kind) {
      return power_of({claim, each, 0, shape, evaluations}, 1, no_progress());
    }
  }
  throw std::logic_error("no place " + place);
}

const Rational one_step = Rational(65) / Rational(64);

// R ≤ Δ/(2Υ), with equality for edges.

TEST(Power, a_planted_slack_of_eight_comes_out_up_to_a_step) {
  const Claim claim = claim_showing("circumradius(s) <= 8*(longest_edge(s)/(2*thickness(s)))");
  const Power power = power_at(claim, "8*(longest_edge(s)/(2*thickness(s)))", {1, 2}, 40, PlaceKind::bound);
  ASSERT_TRUE(power.scale.has_value());
  EXPECT_LT(*power.scale, Rational(1) / Rational(8));
  EXPECT_GE(*power.scale * one_step, Rational(1) / Rational(8));
  // The witness does what is said of it, and the claim itself holds on it.
  const Claim moved = claim_showing(power.changed);
  EXPECT_EQ(attempt(moved, power.witness.value()).conclusions.at(0).verdict, Verdict::refuted);
  EXPECT_EQ(attempt(claim, *power.witness).conclusions.at(0).verdict, Verdict::proved);
}

TEST(Power, a_lower_bound_is_scaled_upwards) {
  const Claim claim = claim_showing("circumradius(s) >= longest_edge(s)/6");
  const Power power = power_at(claim, "longest_edge(s)/6", {2, 2}, 200, PlaceKind::bound);
  ASSERT_TRUE(power.scale.has_value());
  EXPECT_GT(*power.scale, Rational(3));
  EXPECT_LE(*power.scale, Rational(3) * one_step * one_step);
}

TEST(Power, a_redundant_term_has_none_and_a_needed_one_has) {
  const Claim claim = claim_showing("circumradius(s) <= longest_edge(s)/(2*thickness(s)) + shortest_edge(s)");
  const Power redundant = power_at(claim, "shortest_edge(s)", {2, 2}, 400);
  EXPECT_TRUE(redundant.has_instance);
  EXPECT_FALSE(redundant.scale.has_value());
  EXPECT_TRUE(redundant.can_be_deleted);
  EXPECT_FALSE(redundant.is_deletion_refuted);
  EXPECT_FALSE(redundant.witness.has_value());
  const Power needed = power_at(claim, "longest_edge(s)/(2*thickness(s))", {2, 2}, 400);
  EXPECT_TRUE(needed.scale.has_value());
  EXPECT_TRUE(needed.is_deletion_refuted);
}

TEST(Power, of_a_term_that_others_hide_only_the_deletion_is_refuted) {
  // Equality for edges: any part of the term less is refuted, but 2^-60 of it is not needed elsewhere.
  const Claim claim =
      claim_showing("circumradius(s) <= longest_edge(s)/2 + (1 - thickness(s))*longest_edge(s)/thickness(s)");
  const Power power = power_at(claim, "(1 - thickness(s))*longest_edge(s)/thickness(s)", {2, 2}, 400);
  EXPECT_TRUE(power.is_deletion_refuted);
  ASSERT_TRUE(power.scale.has_value());
  EXPECT_LT(*power.scale, Rational(1));
}

TEST(Power, a_factor_is_deleted_and_one_whose_deletion_says_less_is_told_apart) {
  const Claim claim = claim_showing("circumradius(s) <= longest_edge(s)/(2*thickness(s))");
  const Power divisor = power_at(claim, "thickness(s)", {2, 2}, 300, PlaceKind::factor);
  EXPECT_TRUE(divisor.is_deletion_refuted);
  const Claim weaker = claim_showing("thickness(s)*circumradius(s) <= longest_edge(s)/2*k");
  const Power left = power_at(weaker, "thickness(s)", {2, 2}, 300, PlaceKind::factor);
  EXPECT_TRUE(left.is_deletion_refuted);
  const Power right =
      power_at(claim_showing("circumradius(s)/k <= longest_edge(s)/thickness(s)"), "k", {2, 2}, 300, PlaceKind::factor);
  EXPECT_FALSE(right.is_deletion_refuted && right.is_weaker);
  const Power less = power_at(claim_showing("circumradius(s) <= thickness(s)*longest_edge(s)/thickness(s)^2"),
                              "thickness(s)", {2, 2}, 300, PlaceKind::factor);
  EXPECT_TRUE(less.is_weaker);
}

TEST(Power, what_is_refuted_anyway_has_the_scale_one) {
  const Power power = power_at(test::wrong_claim(), "longest_edge(s)", {2, 2}, 200, PlaceKind::bound);
  EXPECT_EQ(power.scale, Rational(1));
}

TEST(Power, a_hypothesis_is_widened_until_the_conclusion_fails) {
  // |R̃ − R| ≤ R/8 for edges holds up to xi = 1/8, eight times the bound.
  const Claim claim = claim_about_pairs("xi <= 1/64", "abs(circumradius(t) - circumradius(s)) <= circumradius(s)/8");
  const Power power = power_at(claim, "1/64", {1, 2}, 60, PlaceKind::bound);
  ASSERT_TRUE(power.scale.has_value());
  EXPECT_GT(*power.scale, Rational(8));
  EXPECT_LE(*power.scale, Rational(8) * one_step * one_step);
  EXPECT_EQ(power.changed.substr(0, 6), "xi <= ");
  // A hypothesis that is not needed has none.
  const Claim unneeded =
      claim_about_pairs("xi <= 1/64", "abs(circumradius(t) - circumradius(s)) <= 5*circumradius(s)*(1 + xi)");
  EXPECT_FALSE(power_at(unneeded, "1/64", {1, 2}, 60, PlaceKind::bound).scale.has_value());
}

TEST(Power, hypotheses_with_a_reason_for_no_twin_are_left_alone) {
  const Claim claim = claim_showing("k <= 2", "given = [{ claim = \"k <= 2\", no_twin = \"why\" }, \"m <= 7\"]\n");
  std::size_t hypotheses = 0;
  for (const PowerPlace& place : power_places(claim)) hypotheses += place.is_hypothesis ? 1 : 0;
  EXPECT_EQ(hypotheses, 1U);
}

TEST(Power, without_an_instance_that_is_said) {
  const Claim never = claim_showing("circumradius(s) <= 2*longest_edge(s)", "given = [\"k = 0\"]\n");
  const Power power = power_at(never, "2*longest_edge(s)", {2, 2}, 20, PlaceKind::bound);
  EXPECT_FALSE(power.has_instance);
  EXPECT_FALSE(power.scale.has_value());
}

TEST(Power, the_same_seed_gives_the_same_and_progress_can_end_it) {
  const Claim claim = claim_showing("circumradius(s) <= 3*longest_edge(s)/thickness(s)");
  const auto run = [&] { return power_at(claim, "3*longest_edge(s)/thickness(s)", {2, 3}, 100, PlaceKind::bound); };
  EXPECT_EQ(run().scale, run().scale);
  EXPECT_EQ(run().evaluations, run().evaluations);
  const PowerTarget target{claim, power_places(claim).at(0), 0, {2, 2}, 100};
  EXPECT_THROW(
      (void)power_of(target, 1, [](std::string_view, std::size_t, std::size_t) { throw std::runtime_error(""); }),
      std::runtime_error);
}

TEST(Power, steps_grow_from_one_to_the_128th_power_of_two) {
  EXPECT_EQ(power_step(0), Rational(1));
  EXPECT_EQ(power_step(1), one_step);
  EXPECT_EQ(power_step(64), Rational(2));
  EXPECT_EQ(power_step(96), Rational(3));
  EXPECT_EQ(power_step(last_power_step), Rational::power_of_two(128));
  for (int level = 0; level < last_power_step; ++level) {
    EXPECT_LT(power_step(level), power_step(level + 1));
    EXPECT_LE(power_step(level + 1), power_step(level) * one_step);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
