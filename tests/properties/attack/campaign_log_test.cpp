#include "properties/attack/campaign_log.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/properties/attack/small_campaign.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::LogLines;
using test::mentions;

// Line 1 says which campaign it is, line 2 which process wrote, lines 3 to 14 are the blocks.
class CampaignLogFile : public testing::Test {
 protected:
  void SetUp() override {
    (void)run_campaign(test::small_campaign(path_), no_progress());
    good_ = test::lines_of(path_);
    ASSERT_EQ(good_.size(), 14U);
  }
  std::string error_of_plan(const CampaignPlan& plan) const {
    return test::message_of<InputError>([&] { const CampaignLog log(plan); });
  }
  /// What the log is refused with, by what reads only and by what goes on from it.
  std::string error() const {
    const std::string read = test::message_of<InputError>([&] { (void)read_campaign(path_); });
    EXPECT_EQ(error_of_plan(test::small_campaign(path_)), read);
    return read;
  }
  std::string error_of(const std::function<void(LogLines&)>& change) const {
    test::write_lines(path_, good_);
    EXPECT_EQ(error(), "accepted");
    test::forge(path_, change);
    return error();
  }
  static bool is_at(int line, const std::string& error, const std::string& reason) {
    return mentions(error, "log.jsonl:" + std::to_string(line) + ": ") && mentions(error, reason);
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "log.jsonl";
  LogLines good_;
};

#define EXPECT_REFUSED(line, reason, ...)                       \
  do {                                                          \
    const std::string error_here = error_of(__VA_ARGS__);       \
    EXPECT_TRUE(is_at(line, error_here, reason)) << error_here; \
  } while (false)

TEST_F(CampaignLogFile, says_what_was_done_where_and_when) {
  const CampaignRecord log = read_campaign(path_);
  EXPECT_EQ(log.finished.size(), 12U);
  ASSERT_EQ(log.writers.size(), 1U);
  EXPECT_EQ(log.writers[0].process, ::getpid());
  EXPECT_FALSE(log.is_torn);
  const BlockRecord& first = log.finished.at({0, 0});
  EXPECT_EQ(tally_json(first.tally).dump(), tally_json(attack_block(test::wrong_claim(), {2, 2}, 3, 0, 10)).dump());
  EXPECT_EQ(first.line, 3U);
  EXPECT_EQ(first.host, log.writers[0].host);
  EXPECT_GE(first.finished, log.writers[0].begun);
  EXPECT_EQ(record_json({0, 0}, first).dump(), good_[2].dump());
}

TEST_F(CampaignLogFile, wherever_a_crash_cuts_it_off_whole_lines_count_and_it_can_go_on) {
  const std::string whole = test::content_of(path_);
  const std::string result = test::text_of(tallies_of(read_campaign(path_).plan, read_campaign(path_).finished));
  const std::size_t first = whole.find('\n') + 1;
  for (std::size_t length = 0; length <= whole.size(); length += length > first ? 1009 : 211) {
    std::ofstream(path_, std::ios::binary) << whole.substr(0, length);
    if (length >= first) {
      EXPECT_EQ(read_campaign(path_).is_torn, whole[length - 1] != '\n') << length;
      // Reading cuts nothing off.
      EXPECT_EQ(test::content_of(path_).size(), length);
    }
    EXPECT_EQ(test::text_of(run_campaign(test::small_campaign(path_), no_progress()).tallies), result) << length;
    EXPECT_EQ(read_campaign(path_).finished.size(), 12U) << length;
  }
}

TEST_F(CampaignLogFile, of_another_campaign_or_part_is_refused_and_left_as_it_is) {
  const std::string before = test::content_of(path_);
  CampaignPlan plan = test::small_campaign(path_);
  plan.seed = 4;
  EXPECT_TRUE(is_at(1, error_of_plan(plan), "the log of another campaign: its seed is 3, not 4"))
      << error_of_plan(plan);
  plan = test::small_campaign(path_);
  plan.targets[0].claim.conclusions[0].text += " ";
  EXPECT_TRUE(is_at(1, error_of_plan(plan), "the text of the claim differs")) << error_of_plan(plan);
  plan = test::small_part(path_, 2, 3);
  EXPECT_TRUE(is_at(1, error_of_plan(plan), "the log of part 1/1, not of part 2/3")) << error_of_plan(plan);
  plan = test::small_campaign(path_);
  plan.targets[1].samples = 34;
  EXPECT_TRUE(mentions(error_of_plan(plan), "the log has 35 samples of right (k=1, m=2), and 34 are asked for"))
      << error_of_plan(plan);
  EXPECT_EQ(test::content_of(path_), before);
}

TEST_F(CampaignLogFile, a_file_that_is_no_log_is_refused_and_left_as_it_is) {
  for (const char* other : {"my diary", "my diary\n", "{}\n", "[1]\n", "\n", "{\"delcert_campaign\": 1}\n"}) {
    std::ofstream(path_, std::ios::binary) << other;
    EXPECT_TRUE(is_at(1, error_of_plan(test::small_campaign(path_)), "")) << other;
    EXPECT_THROW((void)read_campaign(path_), InputError) << other;
    EXPECT_EQ(test::content_of(path_), other);
  }
}

TEST_F(CampaignLogFile, a_block_twice_is_refused_the_same_in_another_log_is_not) {
  EXPECT_REFUSED(15, "block 0 (wrong, k=2, m=2, samples 0 to 9) is there twice, in line 3 already",
                 [](LogLines& lines) { lines.push_back(lines[2]); });
}

TEST_F(CampaignLogFile, a_block_that_is_none_of_the_campaign_or_of_its_part_is_refused) {
  EXPECT_REFUSED(3, "target 7, first 0 is no block", [](LogLines& lines) { lines[2]["target"] = 7; });
  EXPECT_REFUSED(3, "target 0, first 5 is no block", [](LogLines& lines) { lines[2]["first"] = 5; });
  EXPECT_REFUSED(3, "target 0, first 70 is no block", [](LogLines& lines) { lines[2]["first"] = 70; });
  test::write_lines(path_, good_);
  test::forge(path_, [](LogLines& lines) { lines[0]["part"] = {1, 2}; });
  const std::string error = test::message_of<InputError>([&] { (void)read_campaign(path_); });
  EXPECT_TRUE(is_at(4, error, "block 1 (wrong, k=2, m=2, samples 10 to 19) is not of part 1/2")) << error;
}

TEST_F(CampaignLogFile, counts_that_do_not_add_up_are_refused) {
  const auto conclusion = [](LogLines & lines) -> auto& { return lines[2]["tally"]["conclusions"][0]; };
  const auto more = [](auto& json) { json = json.template get<int>() + 1; };
  EXPECT_REFUSED(3, "are not the", [&](LogLines& lines) { more(conclusion(lines)["held"]); });
  EXPECT_REFUSED(3, "are not the", [&](LogLines& lines) { more(conclusion(lines)["violated"]); });
  EXPECT_REFUSED(3, "are not the", [&](LogLines& lines) { more(lines[2]["tally"]["hypotheses_not_met"]); });
  EXPECT_REFUSED(3, "are not the", [&](LogLines& lines) { conclusion(lines)["held"] = 18446744073709551615U; });
  EXPECT_REFUSED(3, "11 samples were counted, and the block has 10",
                 [&](LogLines& lines) { more(lines[2]["tally"]["samples"]); });
  EXPECT_REFUSED(3, "more samples were discarded", [&](LogLines& lines) { lines[2]["tally"]["not_drawn"] = 11; });
  EXPECT_REFUSED(3, "more instances have a trait", [&](LogLines& lines) { lines[2]["tally"]["traits"][0] = 11; });
  EXPECT_REFUSED(3, "the instances on all manifolds",
                 [&](LogLines& lines) { lines[2]["tally"]["manifolds"]["sphere"] = 1; });
  EXPECT_REFUSED(3, "the claim has 1 conclusions, and 2 were counted",
                 [&](LogLines& lines) { lines[2]["tally"]["conclusions"].push_back(conclusion(lines)); });
  EXPECT_REFUSED(3, "sample 10 of the worst ratio is not of the block",
                 [&](LogLines& lines) { conclusion(lines)["worst_sample"] = 10; });
  EXPECT_REFUSED(3, "sample 99 of the first violation is not of the block",
                 [&](LogLines& lines) { conclusion(lines)["first_violation"] = 99; });
}

TEST_F(CampaignLogFile, a_violation_without_its_instance_is_refused) {
  EXPECT_REFUSED(3, "radius is violated, and the instance that violates it is missing",
                 [](LogLines& lines) { lines[2]["violations"].clear(); });
  EXPECT_REFUSED(3, "there is an instance that violates a conclusion, and none was counted",
                 [](LogLines& lines) { lines[2]["violations"]["diameter"] = 1; });
}

TEST_F(CampaignLogFile, a_first_line_that_does_not_fit_its_digest_is_refused) {
  test::forge(path_, [](LogLines& lines) { lines[0]["seed"] = 4; });
  EXPECT_TRUE(is_at(1, error(), "the digest is not that")) << error();
  test::write_lines(path_, good_);
  test::forge(path_, [](LogLines& lines) {
    auto text = lines[0]["claims"][0]["text"].get<std::string>();
    lines[0]["claims"][0]["text"] = text.replace(text.find("longest_edge"), 12, "shortest_edge");
  });
  EXPECT_TRUE(is_at(1, error(), "the digest is not that")) << error();
}

TEST_F(CampaignLogFile, whoever_does_not_compute_sums_anew_is_refused_at_the_line) {
  const std::string good = test::content_of(path_);
  std::vector<std::string> lines;
  std::istringstream stream(good);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const auto error_with = [&](const std::vector<std::string>& changed) {
    std::ofstream out(path_, std::ios::binary);
    for (const std::string& line : changed) out << line << "\n";
    out.close();
    return error();
  };
  EXPECT_EQ(error_with(lines), "accepted");
  auto changed = lines;
  const std::size_t held = changed[4].find("\"samples\":10");
  ASSERT_NE(held, std::string::npos);
  changed[4].replace(held, 12, "\"samples\":11");
  EXPECT_TRUE(is_at(5, error_with(changed), "its sum is not that")) << error();
  changed = lines;
  changed.erase(changed.begin() + 5);
  EXPECT_TRUE(is_at(6, error_with(changed), "a line was changed, doubled, left out or put in")) << error();
  changed = lines;
  changed[6].resize(40);
  EXPECT_TRUE(is_at(7, error_with(changed), "there is no sum at its end")) << error();
  changed = lines;
  changed.insert(changed.begin() + 7, lines[6]);
  EXPECT_TRUE(is_at(8, error_with(changed), "its sum is not that")) << error();
}

TEST_F(CampaignLogFile, is_extended_by_samples_and_never_shortened) {
  CampaignPlan longer = test::small_campaign(path_);
  longer.targets[0].samples = 91;
  { const CampaignLog log(longer); }
  const CampaignRecord extended = read_campaign(path_);
  EXPECT_EQ(extended.plan.targets[0].samples, 91U);
  // The block of five samples is one of ten now.
  EXPECT_EQ(extended.finished.size(), 11U);
  EXPECT_FALSE(extended.finished.contains({0, 60}));
  EXPECT_TRUE(mentions(error_of_plan(test::small_campaign(path_)), "and 65 are asked for"));
  const auto extension = [&](const std::vector<int>& samples) {
    test::write_lines(path_, good_);
    test::forge(path_, [&](LogLines& lines) { lines.push_back({{"samples", samples}}); });
    return test::message_of<InputError>([&] { (void)read_campaign(path_); });
  };
  EXPECT_EQ(extension({65, 35, 2}), "accepted");
  EXPECT_TRUE(is_at(15, extension({65, 34, 2}), "right (k=1, m=2) has fewer samples than before"));
  EXPECT_TRUE(is_at(15, extension({65, 35, 1}), "an extension by nothing"));
  EXPECT_TRUE(is_at(15, extension({65, 35}), "a number of samples for each target"));
}

TEST_F(CampaignLogFile, an_empty_path_keeps_nothing_and_one_that_cannot_be_written_is_an_error) {
  CampaignPlan plan = test::small_campaign("");
  EXPECT_NO_THROW((void)run_campaign(plan, no_progress()));
  plan.log = folder_.path();
  EXPECT_THROW(CampaignLog{plan}, InputError);
  plan.log = folder_ / "none/log.jsonl";
  EXPECT_THROW(CampaignLog{plan}, InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
