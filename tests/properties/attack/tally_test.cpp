#include "properties/attack/tally.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"
#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::claim_about_simplices;
using test::right_claim;
using test::wrong_claim;

std::string text_of(const Tally& tally) { return tally_json(tally).dump(); }

TEST(Tally, blocks_added_in_order_are_the_same_as_one_block) {
  for (const Claim& claim : {wrong_claim(), right_claim()}) {
    const Tally whole = attack_block(claim, {2, 3}, 5, 0, 60);
    EXPECT_EQ(whole.samples, 60U);
    for (const std::uint64_t cut : {1U, 17U, 59U}) {
      Tally sum = attack_block(claim, {2, 3}, 5, 0, cut);
      sum.add(attack_block(claim, {2, 3}, 5, cut, 60 - cut));
      EXPECT_EQ(text_of(sum), text_of(whole)) << cut;
    }
  }
}

TEST(Tally, samples_depend_on_the_seed_the_shape_and_the_claim) {
  const std::string one = text_of(attack_block(wrong_claim(), {2, 3}, 5, 0, 60));
  EXPECT_NE(text_of(attack_block(wrong_claim(), {2, 3}, 6, 0, 60)), one);
  EXPECT_NE(text_of(attack_block(wrong_claim(), {3, 3}, 5, 0, 60)), one);
  EXPECT_NE(text_of(attack_block(wrong_claim(), {2, 3}, 5, 60, 60)), one);
  EXPECT_NE(text_of(attack_block(wrong_claim(), {2, 3}, 5, std::uint64_t{1} << 32U, 60)), one);
}

TEST(Tally, what_was_counted_is_what_single_samples_say) {
  const Claim claim = wrong_claim();
  const Tally tally = attack_block(claim, {2, 2}, 1, 0, 40);
  std::uint64_t held = 0;
  std::uint64_t violated = 0;
  std::uint64_t not_drawn = 0;
  std::optional<std::uint64_t> first;
  double worst = 0;
  for (std::uint64_t number = 0; number < 40; ++number) {
    const auto instance = sample_instance(claim, {2, 2}, 1, number);
    if (!instance) {
      ++not_drawn;
      continue;
    }
    const ConclusionOutcome outcome = attempt(claim, instance->bindings).conclusions.at(0);
    held += is_proved(outcome.verdict) ? 1U : 0U;
    violated += is_refuted(outcome.verdict) ? 1U : 0U;
    if (is_refuted(outcome.verdict) && !first) first = number;
    if (outcome.ratio) worst = std::max(worst, outcome.ratio->lower);
  }
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(tally.conclusions.at(0).held, held);
  EXPECT_EQ(tally.conclusions[0].violated, violated);
  EXPECT_EQ(tally.conclusions[0].undecided, 0U);
  EXPECT_EQ(tally.conclusions[0].first_violation, *first);
  EXPECT_EQ(tally.conclusions[0].worst->lower, worst);
  EXPECT_EQ(tally.not_drawn, not_drawn);
  EXPECT_EQ(tally.met(), 40 - not_drawn);
  EXPECT_EQ(tally.manifolds, (std::map<std::string, std::uint64_t>{{"ℝᵐ", tally.met()}}));
  EXPECT_TRUE(tally.is_refuted());
  EXPECT_EQ(tally.undecided(), 0U);
}

TEST(Tally, hypotheses_that_fail_are_discards) {
  const Claim claim = claim_about_simplices("a", "given = [\"k = 1\"]\n[[show]]\nclaim = \"k = 1\"\n");
  const Tally met = attack_block(claim, {1, 1}, 1, 0, 10);
  EXPECT_EQ(met.hypotheses_not_met, 0U);
  EXPECT_EQ(met.conclusions.at(0).held, met.met());
  const Tally never = attack_block(claim, {2, 2}, 1, 0, 10);
  EXPECT_EQ(never.met(), 0U);
  EXPECT_EQ(never.hypotheses_not_met + never.not_drawn, 10U);
  EXPECT_FALSE(never.is_refuted());
}

TEST(Tally, instances_are_counted_by_the_manifolds_they_live_in) {
  const Tally tally = attack_block(find_claim("exponential-chart-distances"), {0, 2}, 1, 0, 40);
  ASSERT_EQ(tally.manifolds.size(), 2U);
  EXPECT_GT(tally.manifolds.at("sphere"), 5U);
  EXPECT_GT(tally.manifolds.at("hyperbolic space"), 5U);
  EXPECT_EQ(tally.manifolds.at("sphere") + tally.manifolds.at("hyperbolic space"), tally.met());
  EXPECT_EQ(tally_from(tally_json(tally)).manifolds, tally.manifolds);
}

TEST(Tally, json_reads_back_with_infinite_bounds_too) {
  Tally tally = attack_block(wrong_claim(), {2, 2}, 1, 0, 40);
  EXPECT_EQ(text_of(tally_from(tally_json(tally))), text_of(tally));
  tally.conclusions[0].worst = DoubleBounds{0x1p-1074, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(text_of(tally_from(tally_json(tally))), text_of(tally));
}

TEST(Tally, json_that_is_of_no_tally_throws) {
  const Tally tally = attack_block(wrong_claim(), {2, 2}, 1, 0, 40);
  const auto good = tally_json(tally);
  for (const auto& [key, value] : good.items()) {
    auto json = good;
    json.erase(key);
    EXPECT_THROW((void)tally_from(json), nlohmann::json::exception) << key;
  }
  for (const char* bound : {"", "x", "0x1p3 ", "nan"}) {
    auto json = tally_json(tally);
    json["conclusions"][0]["worst"][1] = bound;
    EXPECT_THROW((void)tally_from(json), InputError) << bound;
  }
  auto json = tally_json(tally);
  json["conclusions"][0].erase("first_violation");
  EXPECT_THROW((void)tally_from(json), nlohmann::json::exception);
}

TEST(Tally, a_ratio_that_is_not_a_number_is_never_the_worst) {
  Tally sum;
  Tally later;
  later.conclusions.resize(1);
  later.conclusions[0].worst = DoubleBounds{std::nan(""), 1};
  sum.add(later);
  EXPECT_FALSE(sum.conclusions.at(0).worst.has_value());
  later.conclusions[0].worst = DoubleBounds{0.25, 0.5};
  sum.add(later);
  EXPECT_EQ(sum.conclusions[0].worst->lower, 0.25);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
