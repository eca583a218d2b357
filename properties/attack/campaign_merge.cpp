#include "properties/attack/campaign_merge.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

/// Of the blocks of the plan, those that are not in the map.
std::vector<Block> missing_of(const CampaignPlan& plan, const std::map<Block, BlockRecord>& finished) {
  std::vector<Block> result;
  for (const Block& block : blocks_of(plan)) {
    if (!finished.contains(block)) result.push_back(block);
  }
  return result;
}

void require_same_samples(const CampaignRecord& one, const CampaignRecord& other) {
  for (std::size_t at = 0; at < one.plan.targets.size(); ++at) {
    const Target& mine = one.plan.targets[at];
    const Target& its = other.plan.targets[at];
    if (mine.samples == its.samples) continue;
    throw InputError(other.path.string() + ": " + std::to_string(its.samples) + " samples of " + name_of(its) +
                     ", where " + one.path.string() + " has " + std::to_string(mine.samples) +
                     ": the shorter one can be extended, by its command with as many --samples");
  }
}

std::string where(const CampaignRecord& log, const BlockRecord& record) {
  return log.path.string() + ":" + std::to_string(record.line);
}

}  // namespace

MergedCampaign merged(const std::vector<CampaignRecord>& logs) {
  MergedCampaign result;
  result.plan = logs.front().plan;
  result.plan.part = {};
  std::map<Block, const CampaignRecord*> sources;
  for (const CampaignRecord& log : logs) {
    try {
      require_same_campaign(result.plan, log.plan);
    } catch (const InputError& error) {
      throw InputError(log.path.string() + ":1: " + error.what() + " (as " + logs.front().path.string() + " has it)");
    }
    require_same_samples(logs.front(), log);
    for (const auto& [block, record] : log.finished) {
      const auto [known, is_new] = result.finished.try_emplace(block, record);
      if (!is_new) {
        throw Rejection(where(log, record) + ": " + name_of(result.plan, block) + " is in " +
                        where(*sources.at(block), known->second) + " already");
      }
      sources[block] = &log;
    }
  }
  const std::vector<Block> missing = missing_of(result.plan, result.finished);
  if (missing.empty()) return result;
  std::string text = missing_text(result.plan, missing);
  const std::uint64_t of = logs.front().plan.part.of;
  if (of > 1 && std::all_of(logs.begin(), logs.end(), [&](const auto& log) { return log.plan.part.of == of; })) {
    text += "; the first is of part " + text_of(Part{part_of(result.plan, missing.front(), of), of});
  }
  throw Undecided(text);
}

std::string merged_text(const MergedCampaign& campaign, const std::vector<CampaignRecord>& logs) {
  Json sources = Json::array();
  std::vector<const CampaignRecord*> sorted;
  for (const CampaignRecord& log : logs) sorted.push_back(&log);
  std::sort(sorted.begin(), sorted.end(),
            [](const CampaignRecord* a, const CampaignRecord* b) { return a->sum < b->sum; });
  for (const CampaignRecord* log : sorted) {
    sources.push_back({{"file", log->path.filename().string()},
                       {"part", {log->plan.part.number, log->plan.part.of}},
                       {"blocks", log->finished.size()},
                       {"sum", log->sum}});
  }
  Chain chain;
  std::string result = chain.seal(header_of(campaign.plan)) + "\n";
  result += chain.seal({{"merged", sources}}) + "\n";
  for (const auto& [block, record] : campaign.finished) result += chain.seal(record_json(block, record)) + "\n";
  return result;
}

std::vector<Block> missing_blocks(const CampaignRecord& log) { return missing_of(log.plan, log.finished); }

std::string missing_text(const CampaignPlan& plan, const std::vector<Block>& missing) {
  constexpr std::size_t most_named = 20;
  std::string result = name_of(plan, missing.front()) + " is missing";
  if (missing.size() == 1) return result;
  result += ", and " + std::to_string(missing.size() - 1) + (missing.size() == 2 ? " other: " : " others: ");
  for (std::size_t at = 1; at < std::min(missing.size(), most_named); ++at) {
    result += (at == 1 ? "" : ", ") + std::to_string(number_of(plan, missing[at]));
  }
  return missing.size() > most_named ? result + ", …" : result;
}

}  // namespace delcert
