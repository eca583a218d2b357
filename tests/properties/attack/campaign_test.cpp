#include "properties/attack/campaign.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/error.hpp"
#include "tests/properties/attack/small_campaign.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

class Campaign : public testing::Test {
 protected:
  void SetUp() override {
    plan_.targets = {
        {test::wrong_claim(), {2, 2}, 60}, {test::right_claim(), {1, 2}, 35}, {test::right_claim(), {2, 2}, 1}};
    plan_.seed = 3;
    plan_.block = 10;
  }

  std::string result() const { return test::text_of(run_campaign(plan_, no_progress()).tallies); }
  std::string error_of() const {
    try {
      (void)run_campaign(plan_, no_progress());
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
  CampaignPlan plan_;
};

TEST_F(Campaign, the_result_is_that_of_single_blocks) {
  const auto tallies = run_campaign(plan_, no_progress()).tallies;
  ASSERT_EQ(tallies.size(), 3U);
  for (std::size_t at = 0; at < 3; ++at) {
    const Target& target = plan_.targets[at];
    EXPECT_EQ(tally_json(tallies[at]).dump(),
              tally_json(attack_block(target.claim, target.shape, 3, 0, target.samples)).dump());
  }
}

TEST_F(Campaign, the_result_depends_neither_on_the_number_of_threads_nor_on_the_blocks) {
  const std::string one = result();
  for (const unsigned threads : {0U, 2U, 5U, 100000U}) {
    plan_.threads = threads;
    EXPECT_EQ(result(), one) << threads;
  }
  plan_.block = 7;
  EXPECT_EQ(result(), one);
  plan_.seed = 4;
  EXPECT_NE(result(), one);
}

TEST_F(Campaign, interrupted_at_any_time_and_resumed_it_gives_the_same) {
  const std::string one = result();
  plan_.log = folder_ / "log.jsonl";
  plan_.threads = 2;
  for (int interruptions = 0; interruptions < 4; ++interruptions) {
    std::size_t last = 0;
    const Progress interrupt = [&](std::string_view, std::size_t done, std::size_t total) {
      EXPECT_LE(done, total);
      EXPECT_GE(done, last);
      last = done;
      if (done > static_cast<std::size_t>(interruptions) * 20) throw std::runtime_error("interrupted");
    };
    try {
      (void)run_campaign(plan_, interrupt);
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "interrupted");
    }
  }
  EXPECT_EQ(result(), one);
  // And from the log alone.
  EXPECT_EQ(result(), one);
}

TEST_F(Campaign, a_log_of_other_claims_parameters_or_seed_is_refused) {
  plan_.log = folder_ / "log.jsonl";
  (void)result();
  EXPECT_EQ(error_of(), "no error");
  const CampaignPlan good = plan_;
  plan_.seed = 4;
  EXPECT_NE(error_of().find("another campaign"), std::string::npos);
  plan_ = good;
  plan_.targets[0].samples = 59;
  EXPECT_NE(error_of().find("samples can only be added"), std::string::npos);
  plan_ = good;
  plan_.targets[1].claim.parameters.at("eta").upper = Rational(2);
  EXPECT_NE(error_of().find("another campaign"), std::string::npos);
  plan_ = good;
  plan_.targets[0].claim.conclusions[0].text += " ";
  EXPECT_NE(error_of().find("another campaign"), std::string::npos);
  plan_ = good;
  plan_.targets.pop_back();
  EXPECT_NE(error_of().find("another campaign"), std::string::npos);
}

TEST_F(Campaign, extended_from_its_log_it_gives_what_the_longer_one_gives) {
  plan_.log = folder_ / "log.jsonl";
  for (const std::uint64_t more : {1U, 9U, 10U, 33U}) {
    for (Target& target : plan_.targets) target.samples += more;
    const std::string extended = result();
    CampaignPlan alone = plan_;
    alone.log = "";
    EXPECT_EQ(extended, test::text_of(run_campaign(alone, no_progress()).tallies)) << more;
  }
  EXPECT_EQ(read_campaign(plan_.log).finished.size(), blocks_of(plan_).size());
}

TEST_F(Campaign, a_log_keeps_its_sizes_of_blocks) {
  plan_.log = folder_ / "log.jsonl";
  const std::string one = result();
  const std::string text = test::content_of(plan_.log);
  plan_.block = 7;
  EXPECT_EQ(result(), one);
  EXPECT_EQ(test::content_of(plan_.log), text) << "what was finished is not done again";
}

TEST_F(Campaign, begins_no_block_after_its_limit) {
  plan_.log = folder_ / "log.jsonl";
  const CampaignOutcome nothing = run_campaign(plan_, no_progress(), std::chrono::seconds(0));
  EXPECT_FALSE(nothing.is_finished());
  EXPECT_EQ(nothing.finished, 0U);
  EXPECT_EQ(nothing.blocks, 11U);
  const CampaignOutcome all = run_campaign(plan_, no_progress(), std::chrono::hours(1));
  EXPECT_TRUE(all.is_finished());
  plan_.log = "";
  EXPECT_EQ(test::text_of(all.tallies), result());
}

TEST_F(Campaign, a_block_done_anew_is_what_the_log_has) {
  plan_.log = folder_ / "log.jsonl";
  (void)result();
  const CampaignRecord log = read_campaign(plan_.log);
  for (const auto& [block, record] : log.finished) {
    const BlockRecord anew = attacked_block(plan_, block);
    EXPECT_EQ(tally_json(anew.tally).dump(), tally_json(record.tally).dump());
    EXPECT_EQ(anew.violations, record.violations);
    EXPECT_EQ(anew.violations.empty(), !anew.tally.is_refuted());
  }
}

TEST_F(Campaign, what_a_worker_throws_arrives_with_claim_and_shape_whatever_the_threads) {
  plan_.targets[1].claim =
      test::claim_about_simplices("asks-too-much", "[[show]]\nclaim = \"altitude(s, 1) > 0 or altitude(s, 9) > 0\"\n");
  plan_.targets[2].claim = plan_.targets[1].claim;
  plan_.targets[1].claim.conclusions[0] =
      test::claim_about_simplices("b", "[[show]]\nclaim = \"altitude(s, 9) > 0\"\n").conclusions[0];
  const std::string one = error_of();
  EXPECT_TRUE(one.starts_with("asks-too-much (k=1, m=2): ")) << one;
  plan_.threads = 4;
  for (int round = 0; round < 5; ++round) EXPECT_EQ(error_of(), one);
}

TEST_F(Campaign, no_targets_and_no_samples_give_empty_tallies) {
  plan_.targets[0].samples = 0;
  EXPECT_EQ(run_campaign(plan_, no_progress()).tallies.at(0).samples, 0U);
  plan_.targets.clear();
  EXPECT_TRUE(run_campaign(plan_, no_progress()).tallies.empty());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
