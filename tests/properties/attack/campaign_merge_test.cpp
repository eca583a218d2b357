#include "properties/attack/campaign_merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/error.hpp"
#include "tests/properties/attack/small_campaign.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::LogLines;
using test::mentions;

class CampaignMerge : public testing::Test {
 protected:
  std::filesystem::path path(std::uint64_t number) const {
    return folder_ / ("part-" + std::to_string(number) + ".jsonl");
  }
  /// Runs the parts 1 … of.
  void run_parts(std::uint64_t of) const {
    for (std::uint64_t number = 1; number <= of; ++number) {
      (void)run_campaign(test::small_part(path(number), number, of), no_progress());
    }
  }
  std::vector<CampaignRecord> read_parts(const std::vector<std::uint64_t>& numbers) const {
    std::vector<CampaignRecord> result;
    for (const std::uint64_t number : numbers) result.push_back(read_campaign(path(number)));
    return result;
  }
  template <class Error>
  std::string error_of(const std::vector<std::uint64_t>& numbers) const {
    return test::message_of<Error>([&] { (void)merged(read_parts(numbers)); });
  }
  static std::string single_run() {
    return test::text_of(run_campaign(test::small_campaign(""), no_progress()).tallies);
  }

  test::TemporaryFolder folder_;
};

TEST_F(CampaignMerge, of_all_parts_is_what_a_single_run_gives_in_whatever_order) {
  for (const std::uint64_t of : {1U, 2U, 5U, 20U}) {
    run_parts(of);
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t number = 1; number <= of; ++number) numbers.push_back(number);
    const auto logs = read_parts(numbers);
    const MergedCampaign whole = merged(logs);
    EXPECT_EQ(whole.finished.size(), 12U);
    EXPECT_EQ(test::text_of(tallies_of(whole.plan, whole.finished)), single_run());
    std::reverse(numbers.begin(), numbers.end());
    const auto backwards = read_parts(numbers);
    EXPECT_EQ(merged_text(merged(backwards), backwards), merged_text(whole, logs));
    for (std::uint64_t number = 1; number <= of; ++number) std::filesystem::remove(path(number));
  }
}

TEST_F(CampaignMerge, its_text_is_the_log_of_the_whole_from_which_it_goes_on) {
  run_parts(3);
  const auto logs = read_parts({1, 2, 3});
  const auto whole = folder_ / "whole.jsonl";
  const std::string text = merged_text(merged(logs), logs);
  std::ofstream(whole, std::ios::binary) << text;
  EXPECT_EQ(test::text_of(run_campaign(test::small_campaign(whole), no_progress()).tallies), single_run());
  EXPECT_EQ(test::content_of(whole), text) << "nothing was left to do";
  CampaignPlan longer = test::small_campaign(whole);
  longer.targets[0].samples = 97;
  const std::string extended = test::text_of(run_campaign(longer, no_progress()).tallies);
  longer.log = "";
  EXPECT_EQ(extended, test::text_of(run_campaign(longer, no_progress()).tallies));
}

TEST_F(CampaignMerge, parts_of_different_cuts_fit_if_they_cover) {
  (void)run_campaign(test::small_part(path(1), 1, 2), no_progress());
  (void)run_campaign(test::small_part(path(2), 2, 4), no_progress());
  (void)run_campaign(test::small_part(path(3), 4, 4), no_progress());
  EXPECT_EQ(merged(read_parts({1, 2, 3})).finished.size(), 12U);
  EXPECT_TRUE(mentions(error_of<Undecided>({1, 2}), "is missing"));
}

TEST_F(CampaignMerge, a_missing_block_is_named_with_its_part) {
  run_parts(4);
  EXPECT_EQ(error_of<Undecided>({1, 2, 3, 4}), "accepted");
  test::forge(path(3), [](LogLines& lines) { lines.erase(lines.begin() + 3); });
  EXPECT_EQ(error_of<Undecided>({1, 2, 3, 4}),
            "block 6 (wrong, k=2, m=2, samples 60 to 64) is missing; the first is of part 3/4");
  EXPECT_EQ(error_of<Undecided>({1, 2, 3}),
            "block 3 (wrong, k=2, m=2, samples 30 to 39) is missing, and 2 others: 6, 9; the "
            "first is of part 4/4");
}

TEST_F(CampaignMerge, a_block_that_two_logs_have_is_refused) {
  run_parts(2);
  std::filesystem::copy_file(path(2), path(3));
  const std::string error = error_of<Rejection>({1, 2, 3});
  EXPECT_TRUE(mentions(error, "part-3.jsonl:3: block 1 (wrong, k=2, m=2, samples 10 to 19) is in ")) << error;
  EXPECT_TRUE(mentions(error, "part-2.jsonl:3 already")) << error;
  EXPECT_EQ(error_of<Rejection>({1, 2}), "accepted");
}

TEST_F(CampaignMerge, logs_of_different_campaigns_are_refused) {
  run_parts(2);
  const auto again = [&](auto change) {
    std::filesystem::remove(path(2));
    CampaignPlan plan = test::small_part(path(2), 2, 2);
    change(plan);
    (void)run_campaign(plan, no_progress());
    return error_of<InputError>({1, 2});
  };
  EXPECT_EQ(again([](CampaignPlan&) {}), "accepted");
  const std::string seed = again([](CampaignPlan& plan) { plan.seed = 4; });
  EXPECT_TRUE(mentions(seed, "part-2.jsonl:1: the log of another campaign: its seed is 4, not 3 (as ")) << seed;
  EXPECT_TRUE(mentions(again([](CampaignPlan& plan) { plan.software = "delcert 8"; }), "made by delcert 8"));
  EXPECT_TRUE(mentions(again([](CampaignPlan& plan) {
                         plan.targets[0].claim = test::claim_about_simplices(
                             "wrong", "[[show]]\nname = \"radius\"\nclaim = \"circumradius(s) < longest_edge(s)\"\n");
                       }),
                       "the text of the claim differs"));
  const std::string samples = again([](CampaignPlan& plan) { plan.targets[1].samples = 40; });
  EXPECT_TRUE(mentions(samples, "40 samples of right (k=1, m=2), where ")) << samples;
}

TEST_F(CampaignMerge, of_extended_parts_is_the_longer_run) {
  run_parts(3);
  CampaignPlan longer = test::small_campaign("");
  longer.targets[0].samples = 130;
  longer.targets[1].samples = 36;
  for (std::uint64_t number = 1; number <= 3; ++number) {
    CampaignPlan plan = longer;
    plan.log = path(number);
    plan.part = {number, 3};
    (void)run_campaign(plan, no_progress());
  }
  const MergedCampaign whole = merged(read_parts({1, 2, 3}));
  EXPECT_EQ(test::text_of(tallies_of(whole.plan, whole.finished)),
            test::text_of(run_campaign(longer, no_progress()).tallies));
}

TEST_F(CampaignMerge, what_is_missing_is_listed_up_to_twenty) {
  run_parts(1);
  CampaignRecord log = read_campaign(path(1));
  EXPECT_TRUE(missing_blocks(log).empty());
  for (Target& target : log.plan.targets) target.samples += 200;
  const auto missing = missing_blocks(log);
  // The blocks of 5, 5 and 1 samples are there, though shorter than they would be.
  EXPECT_EQ(missing.size(), 60U);
  EXPECT_TRUE(mentions(missing_text(log.plan, missing), "is missing, and 59 others: 8, 9,"));
  EXPECT_TRUE(missing_text(log.plan, missing).ends_with(", …"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
