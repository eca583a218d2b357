#include "properties/attack/campaign_plan.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"
#include "tests/support/message_of.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;

CampaignPlan small_plan() {
  CampaignPlan plan;
  plan.targets = {
      {test::wrong_claim(), {2, 2}, 65}, {test::right_claim(), {1, 2}, 35}, {test::right_claim(), {2, 2}, 1}};
  plan.seed = 3;
  plan.software = "delcert 7";
  plan.block = 10;
  return plan;
}

std::string error_of(const Json& header) {
  try {
    (void)plan_from(header);
  } catch (const InputError& error) {
    return error.what();
  } catch (const nlohmann::json::exception& error) {
    return std::string("JSON: ") + error.what();
  }
  return "no error";
}

TEST(CampaignPlan, its_blocks_hold_each_sample_once) {
  const CampaignPlan plan = small_plan();
  const auto blocks = blocks_of(plan);
  EXPECT_EQ(blocks.size(), 12U);
  std::vector<std::uint64_t> next(3, 0);
  std::uint64_t number = 0;
  for (const Block& block : blocks) {
    EXPECT_TRUE(is_block(plan, block));
    EXPECT_EQ(number_of(plan, block), number++);
    EXPECT_EQ(block.first, next[block.target]);
    next[block.target] += count_of(plan, block);
  }
  EXPECT_EQ(next, (std::vector<std::uint64_t>{65, 35, 1}));
  for (const Block& none : {Block{0, 65}, Block{0, 5}, Block{0, 70}, Block{3, 0}, Block{2, 10}}) {
    EXPECT_FALSE(is_block(plan, none));
  }
}

TEST(CampaignPlan, blocks_are_neither_many_nor_empty) {
  CampaignPlan plan = small_plan();
  Target target = plan.targets[0];
  EXPECT_EQ(block_size(plan, target), 10U);
  EXPECT_EQ(block_count(plan, target), 7U);
  target.samples = 1000000000000;
  EXPECT_EQ(block_size(plan, target), 50000000U);
  target.block = 7;
  EXPECT_EQ(block_size(plan, target), 7U);
  plan.block = 0;
  target.block = 0;
  target.samples = 5;
  EXPECT_EQ(block_size(plan, target), 1U);
}

TEST(CampaignPlan, parts_share_the_blocks_evenly_and_keep_theirs_when_samples_are_added) {
  for (const std::uint64_t of : {1U, 2U, 3U, 8U, 20U}) {
    std::map<Block, std::uint64_t> owner;
    for (std::uint64_t number = 1; number <= of; ++number) {
      CampaignPlan plan = small_plan();
      plan.part = {number, of};
      const auto blocks = blocks_of(plan);
      EXPECT_LE(blocks.size(), 12 / of + 3);
      for (const Block& block : blocks) EXPECT_TRUE(owner.emplace(block, number).second);
    }
    EXPECT_EQ(owner.size(), 12U);
    CampaignPlan longer = small_plan();
    for (Target& target : longer.targets) target.samples += 123;
    for (const auto& [block, number] : owner) EXPECT_EQ(part_of(longer, block, of), number);
  }
}

TEST(CampaignPlan, comes_back_from_its_header) {
  CampaignPlan plan = small_plan();
  plan.part = {2, 8};
  const Json header = header_of(plan);
  const CampaignPlan back = plan_from(header);
  EXPECT_EQ(header_of(back).dump(), header.dump());
  EXPECT_EQ(back.seed, 3U);
  EXPECT_EQ(back.part, plan.part);
  EXPECT_EQ(back.targets[1].samples, 35U);
  EXPECT_EQ(back.targets[1].claim.file, "right.toml");
  EXPECT_NO_THROW(require_same_campaign(plan, back));
}

TEST(CampaignPlan, a_header_that_says_something_else_than_its_digest_is_refused) {
  const Json header = header_of(small_plan());
  EXPECT_EQ(error_of(header), "no error");
  const auto changed = [&](auto change) {
    Json json = header;
    change(json);
    return error_of(json);
  };
  const std::string digest = "the digest is not that";
  EXPECT_NE(changed([](Json& json) { json["seed"] = 4; }).find(digest), std::string::npos);
  EXPECT_NE(changed([](Json& json) { json["software"] = "delcert 8"; }).find(digest), std::string::npos);
  EXPECT_NE(changed([](Json& json) { json["targets"][0]["block"] = 20; }).find(digest), std::string::npos);
  EXPECT_NE(changed([](Json& json) { json["targets"].erase(2); }).find(digest), std::string::npos);
  EXPECT_NE(changed([](Json& json) {
              auto text = json["claims"][0]["text"].get<std::string>();
              json["claims"][0]["text"] = text.replace(text.find("<="), 2, "< ");
            }).find(digest),
            std::string::npos);
  // The twin: samples and parts are no part of what the digest is of.
  EXPECT_EQ(changed([](Json& json) { json["targets"][0]["samples"] = 66; }), "no error");
  EXPECT_EQ(changed([](Json& json) { json["part"] = {2, 2}; }), "no error");
  EXPECT_EQ(changed([](Json& json) { json["claims"][0]["file"] = "elsewhere.toml"; }), "no error");
}

TEST(CampaignPlan, a_header_that_is_none_is_refused) {
  const Json header = header_of(small_plan());
  const auto changed = [&](auto change) {
    Json json = header;
    change(json);
    return error_of(json);
  };
  EXPECT_NE(changed([](Json& json) { json["delcert_campaign"] = 1; }).find("another version"), std::string::npos);
  EXPECT_NE(changed([](Json& json) { json["part"] = {0, 2}; }).find("0/2 is no part"), std::string::npos);
  EXPECT_NE(changed([](Json& json) { json["part"] = {3, 2}; }).find("3/2 is no part"), std::string::npos);
  EXPECT_NE(changed([](Json& json) { json["targets"][0]["block"] = 0; }).find("no samples"), std::string::npos);
  EXPECT_NE(changed([](Json& json) { json["targets"][0]["claim"] = 2; }).find("no claim 2"), std::string::npos);
  EXPECT_NE(changed([](Json& json) { json["targets"][0]["k"] = 9; }).find("does not have this shape"),
            std::string::npos);
  EXPECT_NE(changed([](Json& json) { json["claims"][0]["text"] = "name = 1"; }).find("claim 0:1"), std::string::npos);
  EXPECT_TRUE(changed([](Json& json) { json.erase("seed"); }).starts_with("JSON: "));
}

TEST(CampaignPlan, what_differs_between_campaigns_is_named) {
  const CampaignPlan plan = small_plan();
  const auto difference = [&](auto change) {
    CampaignPlan other = plan;
    change(other);
    EXPECT_NE(digest_of(other), digest_of(plan));
    return test::message_of<InputError>([&] { require_same_campaign(plan, other); });
  };
  EXPECT_EQ(difference([](CampaignPlan& other) { other.seed = 4; }),
            "the log of another campaign: its seed is 4, not 3");
  EXPECT_EQ(difference([](CampaignPlan& other) { other.software = "delcert 8"; }),
            "the log of another campaign: it was made by delcert 8, not by delcert 7");
  EXPECT_EQ(difference([](CampaignPlan& other) { other.targets.pop_back(); }),
            "the log of another campaign: target 2, right (k=2, m=2), is missing");
  EXPECT_EQ(difference([](CampaignPlan& other) { other.targets.push_back(other.targets[0]); }),
            "the log of another campaign: target 3, wrong (k=2, m=2), is not attacked here");
  EXPECT_EQ(difference([](CampaignPlan& other) {
              other.targets[1].shape = {2, 3};
            }),
            "the log of another campaign: target 1 is right (k=2, m=3), not right (k=1, m=2)");
  EXPECT_EQ(difference([](CampaignPlan& other) { other.targets[0].claim.conclusions[0].text += " "; }),
            "the log of another campaign: target 0, wrong (k=2, m=2): the text of the claim differs");
  EXPECT_EQ(difference([](CampaignPlan& other) { other.targets[0].block = 11; }),
            "the log of another campaign: target 0, wrong (k=2, m=2): its blocks have 11 samples, not 10");
  // The twin: what results do not depend on.
  CampaignPlan same = plan;
  same.targets[0].samples = 7;
  same.threads = 9;
  same.part = {1, 2};
  EXPECT_NO_THROW(require_same_campaign(plan, same));
  EXPECT_EQ(digest_of(same), digest_of(plan));
}

TEST(CampaignPlan, blocks_and_parts_are_called_by_their_names) {
  EXPECT_EQ(name_of(small_plan(), Block{1, 30}), "block 10 (right, k=1, m=2, samples 30 to 34)");
  EXPECT_EQ(text_of(Part{3, 8}), "3/8");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
