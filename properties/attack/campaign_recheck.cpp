#include "properties/attack/campaign_recheck.hpp"

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>

#include "properties/attack/attempt.hpp"
#include "properties/attack/campaign.hpp"
#include "properties/attack/job_pool.hpp"
#include "properties/attack/witness.hpp"
#include "properties/instances/choices.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

/// What of a record does not depend on where and when it was made.
Json result_json(const Block& block, const BlockRecord& record) {
  Json result = record_json(block, record);
  for (const char* key : {"host", "finished", "seconds"}) result.erase(key);
  return result;
}

/// "/tally/conclusions/0/held is 7 and not 8"; empty if they are the same.
std::string difference(const Json& there, const Json& anew) {
  if (there == anew) return "";
  const Json a = there.flatten();
  const Json b = anew.flatten();
  for (const auto& [key, value] : a.items()) {
    if (!b.contains(key)) return key + " should not be there";
    if (b.at(key) != value) return key + " is " + value.dump() + " and should be " + b.at(key).dump();
  }
  for (const auto& [key, value] : b.items()) {
    if (!a.contains(key)) return key + " is missing";
  }
  return "written otherwise";
}

/// A sample on which the tallies rest, and what is said of it.
struct Evidence {
  Block block;
  std::size_t conclusion = 0;
  std::uint64_t sample = 0;
  std::optional<DoubleBounds> worst;  ///< the ratio; or it violates the conclusion
};

bool is_same(const std::optional<DoubleBounds>& a, const DoubleBounds& b) {
  return a && a->lower == b.lower && a->upper == b.upper;
}

/// Empty if it is so.
std::string complaint(const CampaignPlan& plan, const Evidence& evidence, const BlockRecord& record) {
  const Target& target = plan.targets[evidence.block.target];
  const std::string& name = target.claim.conclusions[evidence.conclusion].name;
  const std::string sample = "sample " + std::to_string(evidence.sample);
  const auto instance = sample_instance(target.claim, target.shape, plan.seed, evidence.sample);
  if (!instance) return sample + " has no instance";
  const Attempt result = attempt(target.claim, instance->bindings);
  if (!is_proved(result.hypotheses)) return sample + " does not meet the hypotheses";
  const ConclusionOutcome& outcome = result.conclusions.at(evidence.conclusion);
  if (evidence.worst) {
    return is_same(outcome.ratio, *evidence.worst) ? "" : "the worst ratio of " + name + " is not that of " + sample;
  }
  if (!is_refuted(outcome.verdict)) return sample + " does not violate " + name;
  const Json bindings = bindings_json(instance->bindings, instance_class(target.claim.instance).signature());
  return bindings.dump() == record.violations.at(name)
             ? ""
             : "the instance that violates " + name + " is not that of " + sample;
}

Block block_of(const CampaignPlan& plan, std::size_t target, std::uint64_t sample) {
  const std::uint64_t size = block_size(plan, plan.targets[target]);
  return {target, sample / size * size};
}

std::vector<Evidence> evidence_of(const CampaignPlan& plan, const std::vector<Tally>& tallies) {
  std::vector<Evidence> result;
  for (std::size_t target = 0; target < tallies.size(); ++target) {
    for (std::size_t at = 0; at < tallies[target].conclusions.size(); ++at) {
      const ConclusionTally& tally = tallies[target].conclusions[at];
      if (tally.violated > 0) {
        result.push_back({block_of(plan, target, tally.first_violation), at, tally.first_violation, std::nullopt});
      }
      if (tally.worst)
        result.push_back({block_of(plan, target, tally.worst_sample), at, tally.worst_sample, tally.worst});
    }
  }
  return result;
}

}  // namespace

std::vector<Block> drawn_blocks(const CampaignRecord& log, std::uint64_t count, std::uint64_t seed) {
  std::vector<Block> result;
  for (const auto& [block, record] : log.finished) result.push_back(block);
  RandomChoices choices(seed, stream_of("recheck"), 0);
  for (std::size_t at = 0; at < count; ++at) {
    const long other = choices.between(static_cast<long>(at), static_cast<long>(result.size()) - 1);
    std::swap(result[at], result[static_cast<std::size_t>(other)]);
  }
  result.resize(count);
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::string> recheck(const CampaignRecord& log, const std::vector<Block>& blocks, unsigned threads,
                                 const Progress& progress) {
  // The claims' functions live in it: made before the threads ask for it.
  (void)full_vocabulary();
  std::vector<std::string> found(blocks.size());
  std::atomic<std::size_t> done = 0;
  const Job job = [&](std::size_t number, const std::atomic<bool>&) {
    const Block& block = blocks[number];
    const BlockRecord& record = log.finished.at(block);
    const std::string text =
        difference(result_json(block, record), result_json(block, attacked_block(log.plan, block)));
    if (!text.empty()) {
      found[number] =
          log.path.string() + ":" + std::to_string(record.line) + ": " + name_of(log.plan, block) + ": " + text;
    }
    ++done;
  };
  run_jobs(blocks.size(), threads, job, [&] { progress("recheck", done, blocks.size()); });
  std::erase(found, "");
  return found;
}

std::uint64_t approximate_noticeable_blocks(std::uint64_t blocks, std::uint64_t drawn) {
  constexpr double may_be_missed = 0.05;
  double missed = 1;
  std::uint64_t k = 0;
  while (missed > may_be_missed) {
    const std::uint64_t not_drawn = blocks - drawn;
    missed *= k < not_drawn ? static_cast<double>(not_drawn - k) / static_cast<double>(blocks - k) : 0;
    ++k;
  }
  return k;
}

void require_evidence(const CampaignPlan& plan, const std::map<Block, BlockRecord>& finished, unsigned threads,
                      const Progress& progress) {
  (void)full_vocabulary();
  const std::vector<Evidence> all = evidence_of(plan, tallies_of(plan, finished));
  std::atomic<std::size_t> done = 0;
  const Job job = [&](std::size_t number, const std::atomic<bool>&) {
    const Evidence& one = all[number];
    const std::string text = complaint(plan, one, finished.at(one.block));
    if (!text.empty()) throw Rejection(name_of(plan, one.block) + ": " + text);
    ++done;
  };
  run_jobs(all.size(), threads, job, [&] { progress("deciding anew", done, all.size()); });
}

}  // namespace delcert
