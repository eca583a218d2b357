#include "properties/attack/attack_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(AttackReport, ratios_have_the_digits_that_both_bounds_share) {
  EXPECT_EQ(ratio_text(std::nullopt), "–");
  EXPECT_EQ(ratio_text(DoubleBounds{0.5, 0.5}), "0.5");
  EXPECT_EQ(ratio_text(DoubleBounds{0.123456781, 0.123456784}), "0.12345678");
  EXPECT_EQ(ratio_text(DoubleBounds{0.97, 1.02}), "[0.97, 1.02]");
  EXPECT_EQ(ratio_text(DoubleBounds{0, infinity}), "unbounded");
}

/// Two targets with one conclusion each.
std::vector<Target> targets() { return {{test::wrong_claim(), {2, 2}, 40}, {test::right_claim(), {0, 3}, 10}}; }

std::vector<Tally> tallies() {
  Tally refuted;
  refuted.samples = 40;
  refuted.not_drawn = 4;
  refuted.hypotheses_not_met = 6;
  refuted.traits = {15, 0, 1};
  refuted.manifolds = {{"hyperbolic space", 20}, {"sphere", 10}};
  refuted.rungs.settled = {999, 0, 1, 0};
  refuted.conclusions.resize(1);
  refuted.conclusions[0].held = 28;
  refuted.conclusions[0].violated = 2;
  refuted.conclusions[0].worst = DoubleBounds{1.5, 1.5};
  Tally nothing;
  nothing.samples = 10;
  nothing.not_drawn = 10;
  nothing.conclusions.resize(1);
  return {refuted, nothing};
}

TEST(AttackReport, the_table_has_a_row_for_each_conclusion_and_shape) {
  const std::string table = attack_table(targets(), tallies(), 100);
  EXPECT_NE(table.find("| wrong / radius | k=2 m=2 | hyperbolic space 66.7 % / sphere 33.3 % | 40 | 25.0 % | 50.0 % | "
                       "0 | 3.3 % | 1.5 | "
                       "99.9 % / 0 / 0.1 % / 0 | 0 | REFUTED (2) |\n"),
            std::string::npos)
      << table;
  EXPECT_NE(
      table.find("| right / radius | m=3 | – | 10 | 100.0 % | 0 | 0 | 0 | – | 0 / 0 / 0 / 0 | 0 | not attacked |\n"),
      std::string::npos)
      << table;
}

TEST(AttackReport, one_manifold_is_named_without_a_share) {
  auto some = tallies();
  some[0].manifolds = {{"ℝᵐ", 30}};
  EXPECT_NE(attack_table(targets(), some, 100).find("| k=2 m=2 | ℝᵐ | 40 |"), std::string::npos);
}

TEST(AttackReport, the_short_table_adds_up_the_shapes_of_the_same_k) {
  std::vector<Target> many{{test::wrong_claim(), {2, 2}, 40}, {test::wrong_claim(), {2, 3}, 40}};
  many.push_back({test::wrong_claim(), {3, 3}, 40});
  many.push_back({test::right_claim(), {0, 2}, 10});
  many.push_back({test::right_claim(), {0, 3}, 10});
  const auto one = tallies();
  const std::string table = attack_table(many, {one[0], one[0], one[0], one[1], one[1]}, 100, true);
  EXPECT_NE(table.find("| wrong / radius | k=2 m=2…3 | hyperbolic space 66.7 % / sphere 33.3 % | 80 | 25.0 % |"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("| REFUTED (4) |"), std::string::npos) << table;
  EXPECT_NE(table.find("| wrong / radius | k=3 m=3 | hyperbolic space 66.7 % / sphere 33.3 % | 40 |"),
            std::string::npos)
      << table;
  // Nets have no k: each dimension for itself.
  EXPECT_NE(table.find("| right / radius | m=2 | – | 10 |"), std::string::npos) << table;
  EXPECT_NE(table.find("| right / radius | m=3 | – | 10 |"), std::string::npos) << table;
}

TEST(AttackReport, verdicts_say_how_many_instances_there_were) {
  auto some = tallies();
  some[0].conclusions[0].violated = 0;
  EXPECT_NE(attack_table(targets(), some, 28).find("| not refuted by 28 instances |"), std::string::npos);
  EXPECT_NE(attack_table(targets(), some, 29).find("| hardly attacked: 28 instances |"), std::string::npos);
  some[0].conclusions[0].undecided = 1;
  EXPECT_NE(attack_table(targets(), some, 1).find("| 1 | undecided |"), std::string::npos);
}

TEST(AttackReport, totals_add_up_the_shapes_and_the_kinds) {
  std::vector<Target> two{{test::wrong_claim(), {2, 2}, 40}, {test::wrong_claim(), {3, 3}, 40}};
  std::vector<Tally> some{tallies()[0], tallies()[0]};
  EXPECT_EQ(totals_text(attack_totals(two, some), 1), "");
  for (Tally& tally : some) tally.conclusions[0].violated = 0;
  const auto totals = attack_totals(two, some);
  ASSERT_EQ(totals.size(), 1U);
  EXPECT_EQ(totals_text(totals, 56),
            "wrong / radius: not refuted by 56 instances in 2 shapes, of them boundary 30, thin 0, cospherical 2; "
            "violations by 1 in 19 such instances would have shown, with probability 95 %\n");
  EXPECT_NE(totals_text(totals, 57).find("hardly attacked: 56 instances in 2 shapes"), std::string::npos);
  EXPECT_EQ(totals_json(totals, 56)[0]["held"], 56);
  EXPECT_EQ(totals_json(totals, 56)[0]["noticeable_share_one_in"], 19);
}

TEST(AttackReport, what_an_attack_would_have_found_is_rounded_to_the_safe_side) {
  EXPECT_EQ(noticeable_share(0), 0U);
  EXPECT_EQ(noticeable_share(4), 0U);
  for (const std::uint64_t instances : {5U, 10U, 28U, 2000U, 1000000U}) {
    const std::uint64_t one_in = noticeable_share(instances);
    const auto unseen = [&](std::uint64_t n) {
      return std::pow(1 - 1 / static_cast<double>(n), static_cast<double>(instances));
    };
    EXPECT_LE(unseen(one_in), 0.05) << instances;
    EXPECT_GT(unseen(one_in + 1), 0.05) << instances;
  }
}

TEST(AttackReport, json_says_the_same) {
  const auto json = attack_json(targets(), tallies(), 100);
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0]["claim"], "wrong");
  EXPECT_EQ(json[0]["k"], 2);
  EXPECT_EQ(json[0]["tally"]["samples"], 40);
  EXPECT_EQ(json[0]["tally"]["conclusions"][0]["name"], "radius");
  EXPECT_EQ(json[0]["tally"]["conclusions"][0]["verdict"], "REFUTED (2)");
  EXPECT_EQ(json[1]["tally"]["conclusions"][0]["verdict"], "not attacked");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
