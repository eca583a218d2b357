#include "properties/attack/campaign.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "properties/attack/job_pool.hpp"
#include "properties/attack/witness.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Clock = std::chrono::steady_clock;

/// The instance of a sample of which the block says that it violates a conclusion.
std::string instance_text(const CampaignPlan& plan, const Target& target, std::uint64_t sample) {
  const auto instance = sample_instance(target.claim, target.shape, plan.seed, sample);
  return bindings_json(instance.value().bindings, instance_class(target.claim.instance).signature()).dump();
}

}  // namespace

BlockRecord attacked_block(const CampaignPlan& plan, const Block& block) {
  const Target& target = plan.targets[block.target];
  const auto begin = Clock::now();
  BlockRecord result;
  try {
    result.tally = attack_block(target.claim, target.shape, plan.seed, block.first, count_of(plan, block));
  } catch (const InputError& error) {
    throw InputError(name_of(target) + ": " + error.what());
  }
  for (std::size_t at = 0; at < result.tally.conclusions.size(); ++at) {
    const ConclusionTally& conclusion = result.tally.conclusions[at];
    if (conclusion.violated == 0) continue;
    result.violations[target.claim.conclusions[at].name] = instance_text(plan, target, conclusion.first_violation);
  }
  constexpr double milliseconds_of_a_second = 1000;
  const auto elapsed = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin);
  result.seconds = static_cast<double>(elapsed.count()) / milliseconds_of_a_second;
  return result;
}

std::vector<Tally> tallies_of(const CampaignPlan& plan, const std::map<Block, BlockRecord>& finished) {
  std::vector<Tally> result(plan.targets.size());
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    result[target].conclusions.resize(plan.targets[target].claim.conclusions.size());
  }
  for (const auto& [block, record] : finished) result[block.target].add(record.tally);
  return result;
}

CampaignOutcome run_campaign(const CampaignPlan& asked, const Progress& progress,
                             std::optional<std::chrono::seconds> limit) {
  const auto begin = Clock::now();
  CampaignLog log(asked);
  const CampaignPlan& plan = log.plan();
  std::vector<Block> missing;
  std::uint64_t total = 0;
  std::uint64_t done_before = 0;
  const std::vector<Block> blocks = blocks_of(plan);
  for (const Block& block : blocks) {
    const std::uint64_t count = count_of(plan, block);
    total += count;
    if (log.finished().contains(block)) {
      done_before += count;
    } else {
      missing.push_back(block);
    }
  }
  if (!missing.empty()) log.begin();
  // The claims' functions live in it: made before the threads ask for it.
  (void)full_vocabulary();
  std::mutex mutex;
  std::atomic<std::uint64_t> done = done_before;
  const Job job = [&](std::size_t number, const std::atomic<bool>&) {
    if (limit && Clock::now() - begin >= *limit) return;
    const Block& block = missing[number];
    BlockRecord record = attacked_block(plan, block);
    const std::scoped_lock lock(mutex);
    done += record.tally.samples;
    log.append(block, std::move(record));
  };
  run_jobs(missing.size(), plan.threads, job, [&] { progress("attack", done, total); });
  return {tallies_of(plan, log.finished()), log.finished(), plan, log.finished().size(), blocks.size()};
}

}  // namespace delcert
