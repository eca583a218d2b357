#include "properties/attack/campaign_recheck.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/error.hpp"
#include "tests/properties/attack/small_campaign.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::LogLines;
using test::mentions;

class CampaignRecheck : public testing::Test {
 protected:
  void SetUp() override { (void)run_campaign(test::small_campaign(path_), no_progress()); }

  std::vector<std::string> differences(unsigned threads = 2) const {
    const CampaignRecord log = read_campaign(path_);
    return recheck(log, drawn_blocks(log, log.finished.size(), 1), threads, no_progress());
  }
  std::string evidence() const {
    const CampaignRecord log = read_campaign(path_);
    return test::message_of<Rejection>([&] { require_evidence(log.plan, log.finished, 2, no_progress()); });
  }
  /// The line of the block of the sample.
  static nlohmann::ordered_json& line_of(LogLines& lines, std::size_t target, std::uint64_t first) {
    return *std::find_if(lines.begin(), lines.end(), [&](const auto& line) {
      return line.contains("target") && line["target"] == target && line["first"] == first;
    });
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "log.jsonl";
};

TEST_F(CampaignRecheck, of_an_honest_log_finds_nothing) {
  EXPECT_TRUE(differences(1).empty());
  EXPECT_TRUE(differences(3).empty());
  EXPECT_EQ(evidence(), "accepted");
}

TEST_F(CampaignRecheck, finds_counts_that_add_up_and_are_false) {
  test::forge(path_, [](LogLines& lines) {
    auto& conclusion = line_of(lines, 0, 20)["tally"]["conclusions"][0];
    ASSERT_GT(conclusion["held"], 0);
    conclusion["held"] = conclusion["held"].get<int>() - 1;
    conclusion["undecided"] = conclusion["undecided"].get<int>() + 1;
  });
  const auto found = differences();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(
      mentions(found[0], "log.jsonl:5: block 2 (wrong, k=2, m=2, samples 20 to 29): /tally/conclusions/0/held is "))
      << found[0];
  EXPECT_EQ(evidence(), "accepted") << "what the tallies rest on is another block";
}

TEST_F(CampaignRecheck, finds_a_violation_that_was_removed_with_its_instance) {
  test::forge(path_, [](LogLines& lines) {
    for (auto& line : lines) {
      if (!line.contains("target") || line["target"] != 0) continue;
      auto& conclusion = line["tally"]["conclusions"][0];
      conclusion["held"] = conclusion["held"].get<int>() + conclusion["violated"].get<int>();
      conclusion["violated"] = 0;
      conclusion.erase("first_violation");
      line["violations"].clear();
    }
  });
  EXPECT_EQ(differences().size(), 7U);
}

TEST_F(CampaignRecheck, evidence_that_is_another_than_that_of_the_sample_is_rejected) {
  const LogLines good = test::lines_of(path_);
  const auto with = [&](auto change) {
    test::write_lines(path_, good);
    test::forge(path_, change);
    return evidence();
  };
  const auto first = read_campaign(path_).finished.at({0, 0}).tally.conclusions[0];
  ASSERT_GT(first.violated, 0U);
  const std::string other_sample = with([&](LogLines& lines) {
    auto& conclusion = line_of(lines, 0, 0)["tally"]["conclusions"][0];
    conclusion["first_violation"] = first.first_violation == 0 ? 1 : 0;
  });
  EXPECT_TRUE(mentions(other_sample, "block 0 (wrong, k=2, m=2, samples 0 to 9): ")) << other_sample;
  const std::string instance =
      with([&](LogLines& lines) { line_of(lines, 0, 0)["violations"]["radius"]["s"]["simplex"] = 7; });
  EXPECT_TRUE(mentions(instance, "the instance that violates radius is not that of sample")) << instance;
  const std::string worst = with([&](LogLines& lines) {
    for (auto& line : lines) {
      if (line.contains("target") && line["target"] == 1)
        line["tally"]["conclusions"][0]["worst"] = {"0x1p-1", "0x1p-1"};
    }
  });
  EXPECT_TRUE(mentions(worst, "the worst ratio of radius is not that of sample")) << worst;
}

TEST_F(CampaignRecheck, draws_each_block_at_most_once_and_other_blocks_for_other_seeds) {
  const CampaignRecord log = read_campaign(path_);
  std::set<std::vector<Block>> draws;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto drawn = drawn_blocks(log, 4, seed);
    EXPECT_EQ(drawn, drawn_blocks(log, 4, seed));
    EXPECT_EQ(std::set<Block>(drawn.begin(), drawn.end()).size(), 4U);
    for (const Block& block : drawn) EXPECT_TRUE(log.finished.contains(block));
    draws.insert(drawn);
  }
  EXPECT_GT(draws.size(), 15U);
  EXPECT_EQ(drawn_blocks(log, 12, 5), blocks_of(log.plan));
}

TEST_F(CampaignRecheck, says_how_many_false_blocks_would_have_shown) {
  // All but one drawn: one false block is missed with probability 1/12, two never.
  EXPECT_EQ(approximate_noticeable_blocks(12, 12), 1U);
  EXPECT_EQ(approximate_noticeable_blocks(12, 11), 2U);
  EXPECT_EQ(approximate_noticeable_blocks(20, 19), 1U);
  EXPECT_EQ(approximate_noticeable_blocks(12, 1), 12U);
  // C(90, k)/C(100, k) is 0.0551 for k = 24 and 0.0479 for 25.
  EXPECT_EQ(approximate_noticeable_blocks(100, 10), 25U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
