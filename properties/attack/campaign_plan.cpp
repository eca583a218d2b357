#include "properties/attack/campaign_plan.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "proofs/certificate/sha256.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/claim_shapes.hpp"
#include "properties/attack/claim_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t most_blocks = 20000;
constexpr int format_version = 2;

/// The claims of the targets, each once, and the number of that of each target.
struct ClaimTexts {
  explicit ClaimTexts(const CampaignPlan& plan) {
    std::map<std::string, std::size_t> known;
    for (const Target& target : plan.targets) {
      const std::string text = claim_text(target.claim);
      const auto [found, is_new] = known.try_emplace(text, texts.size());
      if (is_new) texts.push_back(text);
      numbers.push_back(found->second);
    }
  }
  std::vector<std::string> texts;
  std::vector<std::size_t> numbers;
};

Json targets_json(const CampaignPlan& plan, const ClaimTexts& claims, bool with_samples) {
  Json result = Json::array();
  for (std::size_t at = 0; at < plan.targets.size(); ++at) {
    const Target& target = plan.targets[at];
    Json one{{"claim", claims.numbers[at]},
             {"k", target.shape.k},
             {"m", target.shape.m},
             {"block", block_size(plan, target)}};
    if (with_samples) one["samples"] = target.samples;
    result.push_back(std::move(one));
  }
  return result;
}

/// The files are for witnesses, which name them. Results do not depend on them, nor does the digest.
Json claims_json(const CampaignPlan& plan, const ClaimTexts& claims) {
  Json result = Json::array();
  for (std::size_t at = 0; at < plan.targets.size(); ++at) {
    if (claims.numbers[at] != result.size()) continue;
    result.push_back({{"file", plan.targets[at].claim.file}, {"text", claims.texts[claims.numbers[at]]}});
  }
  return result;
}

std::string digest_of(const CampaignPlan& plan, const ClaimTexts& claims) {
  const Json all{{"software", plan.software},
                 {"seed", plan.seed},
                 {"claims", claims.texts},
                 {"targets", targets_json(plan, claims, false)}};
  Sha256 hash;
  hash.update(all.dump());
  return hash.digest();
}

}  // namespace

std::string text_of(const Part& part) { return std::to_string(part.number) + "/" + std::to_string(part.of); }

std::uint64_t block_size(const CampaignPlan& plan, const Target& target) {
  if (target.block > 0) return target.block;
  const std::uint64_t cost = std::max<std::uint64_t>(1, instance_class(target.claim.instance).cost(target.shape));
  return std::max({std::uint64_t{1}, plan.block / cost, target.samples / most_blocks});
}

std::uint64_t block_count(const CampaignPlan& plan, const Target& target) {
  const std::uint64_t size = block_size(plan, target);
  return target.samples / size + (target.samples % size > 0 ? 1 : 0);
}

bool is_block(const CampaignPlan& plan, const Block& block) {
  return block.target < plan.targets.size() && block.first < plan.targets[block.target].samples &&
         block.first % block_size(plan, plan.targets[block.target]) == 0;
}

std::uint64_t count_of(const CampaignPlan& plan, const Block& block) {
  const Target& target = plan.targets[block.target];
  return std::min(block_size(plan, target), target.samples - block.first);
}

std::uint64_t part_of(const CampaignPlan& plan, const Block& block, std::uint64_t of) {
  return (block.first / block_size(plan, plan.targets[block.target]) + block.target) % of + 1;
}

std::vector<Block> blocks_of(const CampaignPlan& plan) {
  std::vector<Block> result;
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    const std::uint64_t size = block_size(plan, plan.targets[target]);
    for (std::uint64_t first = 0; first < plan.targets[target].samples; first += size) {
      const Block block{target, first};
      if (part_of(plan, block, plan.part.of) == plan.part.number) result.push_back(block);
    }
  }
  return result;
}

std::uint64_t number_of(const CampaignPlan& plan, const Block& block) {
  std::uint64_t result = block.first / block_size(plan, plan.targets[block.target]);
  for (std::size_t target = 0; target < block.target; ++target) result += block_count(plan, plan.targets[target]);
  return result;
}

std::string name_of(const CampaignPlan& plan, const Block& block) {
  const Target& target = plan.targets[block.target];
  return "block " + std::to_string(number_of(plan, block)) + " (" + target.claim.name +
         ", k=" + std::to_string(target.shape.k) + ", m=" + std::to_string(target.shape.m) + ", samples " +
         std::to_string(block.first) + " to " + std::to_string(block.first + count_of(plan, block) - 1) + ")";
}

std::string name_of(const Target& target) {
  return target.claim.name + " (k=" + std::to_string(target.shape.k) + ", m=" + std::to_string(target.shape.m) + ")";
}

std::string digest_of(const CampaignPlan& plan) { return digest_of(plan, ClaimTexts(plan)); }

Json header_of(const CampaignPlan& plan) {
  const ClaimTexts claims(plan);
  return {{"delcert_campaign", format_version},
          {"software", plan.software},
          {"seed", plan.seed},
          {"part", {plan.part.number, plan.part.of}},
          {"claims", claims_json(plan, claims)},
          {"targets", targets_json(plan, claims, true)},
          {"digest", digest_of(plan, claims)}};
}

CampaignPlan plan_from(const Json& header) {
  if (header.at("delcert_campaign") != format_version) {
    throw InputError("the log of another version of delcert: format " + std::to_string(format_version) +
                     " was expected");
  }
  CampaignPlan plan;
  header.at("software").get_to(plan.software);
  header.at("seed").get_to(plan.seed);
  plan.part = {header.at("part").at(0).get<std::uint64_t>(), header.at("part").at(1).get<std::uint64_t>()};
  if (plan.part.number < 1 || plan.part.number > plan.part.of) {
    throw InputError(text_of(plan.part) + " is no part: the first number is at least 1 and at most the second");
  }
  std::vector<Claim> claims;
  for (const Json& json : header.at("claims")) {
    claims.push_back(parse_claim(json.at("text").get<std::string>(), "claim " + std::to_string(claims.size()),
                                 full_vocabulary(), all_signatures()));
    json.at("file").get_to(claims.back().file);
  }
  for (const Json& json : header.at("targets")) {
    const Shape shape{json.at("k").get<int>(), json.at("m").get<int>()};
    const auto number = json.at("claim").get<std::size_t>();
    if (number >= claims.size()) throw InputError("there is no claim " + std::to_string(number));
    Target target{claims[number], shape, json.at("samples").get<std::uint64_t>(),
                  json.at("block").get<std::uint64_t>()};
    if (target.block == 0) throw InputError("a block of no samples");
    if (!has_shape(target.claim, shape)) {
      throw InputError(name_of(target) + ": its class does not have this shape");
    }
    plan.targets.push_back(std::move(target));
  }
  if (header.at("digest") != digest_of(plan)) {
    throw InputError("the digest is not that of software, seed, claims and targets as they stand here");
  }
  return plan;
}

void require_same_campaign(const CampaignPlan& plan, const CampaignPlan& other) {
  const ClaimTexts claims(plan);
  const ClaimTexts others(other);
  const auto refuse = [](const std::string& what) { throw InputError("the log of another campaign: " + what); };
  if (plan.software != other.software) refuse("it was made by " + other.software + ", not by " + plan.software);
  if (plan.seed != other.seed) {
    refuse("its seed is " + std::to_string(other.seed) + ", not " + std::to_string(plan.seed));
  }
  for (std::size_t at = 0; at < std::max(plan.targets.size(), other.targets.size()); ++at) {
    const std::string number = "target " + std::to_string(at);
    if (at >= plan.targets.size()) refuse(number + ", " + name_of(other.targets[at]) + ", is not attacked here");
    if (at >= other.targets.size()) refuse(number + ", " + name_of(plan.targets[at]) + ", is missing");
    const Target& mine = plan.targets[at];
    const Target& its = other.targets[at];
    if (name_of(mine) != name_of(its)) refuse(number + " is " + name_of(its) + ", not " + name_of(mine));
    if (claims.texts[claims.numbers[at]] != others.texts[others.numbers[at]]) {
      refuse(number + ", " + name_of(mine) + ": the text of the claim differs");
    }
    if (block_size(plan, mine) != block_size(other, its)) {
      refuse(number + ", " + name_of(mine) + ": its blocks have " + std::to_string(block_size(other, its)) +
             " samples, not " + std::to_string(block_size(plan, mine)));
    }
  }
}

}  // namespace delcert
