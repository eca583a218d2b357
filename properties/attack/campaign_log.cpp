#include "properties/attack/campaign_log.hpp"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "support/error.hpp"
#include "support/host.hpp"
#include "support/utc_time.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kind_of_log = "campaign";

void require(bool fits, const std::string& complaint) {
  if (!fits) throw InputError(complaint);
}

void require_conclusion(const ConclusionTally& tally, const std::string& name, const Block& block, std::uint64_t count,
                        std::uint64_t met) {
  const auto is_inside = [&](std::uint64_t sample) { return sample >= block.first && sample - block.first < count; };
  require(tally.held <= met && tally.violated <= met && tally.undecided <= met &&
              tally.held + tally.violated + tally.undecided == met,
          name + ": " + std::to_string(tally.held) + " held, " + std::to_string(tally.violated) + " violated and " +
              std::to_string(tally.undecided) + " undecided are not the " + std::to_string(met) +
              " instances that meet the hypotheses");
  require(tally.violated == 0 || is_inside(tally.first_violation),
          name + ": sample " + std::to_string(tally.first_violation) + " of the first violation is not of the block");
  require(!tally.worst || is_inside(tally.worst_sample),
          name + ": sample " + std::to_string(tally.worst_sample) + " of the worst ratio is not of the block");
}

BlockRecord record_from(const Json& json, std::size_t line) {
  BlockRecord result;
  result.tally = tally_from(json.at("tally"));
  for (const auto& [name, instance] : json.at("violations").items()) result.violations[name] = instance.dump();
  json.at("host").get_to(result.host);
  json.at("finished").get_to(result.finished);
  (void)parse_utc(result.finished);
  json.at("seconds").get_to(result.seconds);
  result.line = line;
  return result;
}

void add_line(CampaignRecord& log, const Json& json, std::size_t line) {
  if (json.contains("samples")) {
    const Json& samples = json.at("samples");
    require(samples.size() == log.plan.targets.size(), "a number of samples for each target was expected");
    bool more = false;
    for (std::size_t at = 0; at < samples.size(); ++at) {
      Target& target = log.plan.targets[at];
      const auto count = samples.at(at).get<std::uint64_t>();
      require(count >= target.samples, name_of(target) + " has fewer samples than before");
      more = more || count > target.samples;
      target.samples = count;
    }
    require(more, "an extension by nothing");
    std::erase_if(log.finished,
                  [&](const auto& one) { return one.second.tally.samples < count_of(log.plan, one.first); });
    return;
  }
  // Written by a merge: of which logs.
  if (json.contains("merged")) return;
  const Block block{json.at("target").get<std::size_t>(), json.at("first").get<std::uint64_t>()};
  const std::string text = "target " + std::to_string(block.target) + ", first " + std::to_string(block.first);
  require(is_block(log.plan, block), text + " is no block of this campaign");
  const std::string name = name_of(log.plan, block);
  require(part_of(log.plan, block, log.plan.part.of) == log.plan.part.number,
          name + " is not of part " + text_of(log.plan.part));
  BlockRecord record = record_from(json, line);
  try {
    require_record_of(log.plan, block, record);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
  const auto [known, is_new] = log.finished.try_emplace(block, std::move(record));
  require(is_new, name + " is there twice, in line " + std::to_string(known->second.line) + " already");
}

/// Whether it has to be extended to be that of the plan.
bool needs_extension(const CampaignPlan& plan, const CampaignPlan& log) {
  bool result = false;
  for (std::size_t at = 0; at < plan.targets.size(); ++at) {
    const std::uint64_t here = plan.targets[at].samples;
    const std::uint64_t there = log.targets[at].samples;
    require(here >= there, "the log has " + std::to_string(there) + " samples of " + name_of(plan.targets[at]) +
                               ", and " + std::to_string(here) + " are asked for: samples can only be added");
    result = result || here > there;
  }
  return result;
}

/// The first line of a log that is there, and the plan with its sizes of blocks.
void agree(CampaignPlan& plan, CampaignRecord& log, const Json& line) {
  log.plan = plan_from(line);
  CampaignPlan mine = plan;
  for (std::size_t at = 0; at < std::min(mine.targets.size(), log.plan.targets.size()); ++at) {
    mine.targets[at].block = log.plan.targets[at].block;
  }
  require_same_campaign(mine, log.plan);
  if (!(log.plan.part == plan.part)) {
    throw InputError("the log of part " + text_of(log.plan.part) + ", not of part " + text_of(plan.part));
  }
  plan = std::move(mine);
}

}  // namespace

void require_record_of(const CampaignPlan& plan, const Block& block, const BlockRecord& record) {
  const Claim& claim = plan.targets[block.target].claim;
  const Tally& tally = record.tally;
  const std::uint64_t count = count_of(plan, block);
  require(tally.samples == count,
          std::to_string(tally.samples) + " samples were counted, and the block has " + std::to_string(count));
  require(tally.not_drawn <= count && tally.hypotheses_not_met <= count && tally.hypotheses_undecided <= count &&
              tally.not_drawn + tally.hypotheses_not_met + tally.hypotheses_undecided <= count,
          "more samples were discarded than there are");
  for (const std::uint64_t trait : tally.traits) {
    require(trait <= tally.met(), "more instances have a trait than meet the hypotheses");
  }
  require(tally.conclusions.size() == claim.conclusions.size(),
          "the claim has " + std::to_string(claim.conclusions.size()) + " conclusions, and " +
              std::to_string(tally.conclusions.size()) + " were counted");
  std::size_t violated = 0;
  for (std::size_t at = 0; at < tally.conclusions.size(); ++at) {
    const std::string& name = claim.conclusions[at].name;
    require_conclusion(tally.conclusions[at], name, block, count, tally.met());
    if (tally.conclusions[at].violated == 0) continue;
    ++violated;
    require(record.violations.contains(name), name + " is violated, and the instance that violates it is missing");
  }
  require(violated == record.violations.size(),
          "there is an instance that violates a conclusion, and none was counted");
  std::uint64_t somewhere = 0;
  for (const auto& [manifold, instances] : tally.manifolds) somewhere += instances;
  require(somewhere == tally.met(), "the instances on all manifolds are not those that meet the hypotheses");
}

Json record_json(const Block& block, const BlockRecord& record) {
  Json violations = Json::object();
  for (const auto& [name, instance] : record.violations) violations[name] = Json::parse(instance);
  return {{"target", block.target},
          {"first", block.first},
          {"tally", tally_json(record.tally)},
          {"violations", std::move(violations)},
          {"host", record.host},
          {"finished", record.finished},
          {"seconds", record.seconds}};
}

CampaignRecord read_campaign(const std::filesystem::path& path) {
  CampaignRecord result;
  result.path = path;
  JobLogContents contents = read_job_log(
      path, kind_of_log, [&](const Json& line, std::size_t) { result.plan = plan_from(line); },
      [&](const Json& line, std::size_t number) { add_line(result, line, number); });
  result.writers = std::move(contents.writers);
  result.is_torn = !contents.file.torn.empty();
  result.sum = std::move(contents.sum);
  return result;
}

CampaignLog::CampaignLog(const CampaignPlan& plan) : plan_(plan) {
  contents_.path = plan.log;
  contents_.plan = plan;
  log_ = std::make_unique<JobLog>(
      plan.log, kind_of_log, plan.log.empty() ? Json() : header_of(plan),
      [this](const Json& line, std::size_t) { agree(plan_, contents_, line); },
      [this](const Json& line, std::size_t number) { add_line(contents_, line, number); });
  bool extend = false;
  try {
    extend = needs_extension(plan_, contents_.plan);
  } catch (const InputError& error) {
    throw InputError(plan.log.string() + ": " + error.what());
  }
  if (!extend) return;
  Json samples = Json::array();
  for (const Target& target : plan_.targets) samples.push_back(target.samples);
  const Json line{{"samples", samples}};
  log_->append(line);
  add_line(contents_, line, 0);
}

void CampaignLog::append(const Block& block, BlockRecord record) {
  record.host = host_name();
  record.finished = utc_text(std::chrono::system_clock::now());
  log_->append(record_json(block, record));
  contents_.finished[block] = std::move(record);
}

}  // namespace delcert
