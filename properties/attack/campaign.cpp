#include "properties/attack/campaign.hpp"

#include <algorithm>
#include <map>
#include <mutex>

#include "properties/attack/campaign_log.hpp"
#include "properties/attack/identity.hpp"
#include "properties/attack/job_pool.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Block = CampaignLog::Block;

constexpr std::uint64_t most_blocks = 20000;

/// Everything on which the result depends.
std::string plan_identity(const CampaignPlan& plan) {
  std::string contents;
  for (const Target& target : plan.targets) {
    contents += contents_of(target.claim, target.shape) + std::to_string(target.samples) + " " +
                std::to_string(block_size(plan, target)) + "\n";
  }
  return identity_of(contents, plan.seed);
}

std::string name_of(const Target& target) {
  return target.claim.name + " (k=" + std::to_string(target.shape.k) + ", m=" + std::to_string(target.shape.m) + ")";
}

/// The samples of a block.
std::uint64_t count_of(const CampaignPlan& plan, const Block& block) {
  const Target& target = plan.targets[block.first];
  return std::min(block_size(plan, target), target.samples - block.second);
}

Tally attack(const CampaignPlan& plan, const Block& block) {
  const Target& target = plan.targets[block.first];
  try {
    return attack_block(target.claim, target.shape, plan.seed, block.second, count_of(plan, block));
  } catch (const InputError& error) {
    throw InputError(name_of(target) + ": " + error.what());
  }
}

/// A log has the right first line and yet something else in it only if somebody has edited it.
void require_of_plan(const CampaignPlan& plan, const Block& block, const Tally& tally) {
  const bool fits = block.first < plan.targets.size() && block.second < plan.targets[block.first].samples &&
                    block.second % block_size(plan, plan.targets[block.first]) == 0 &&
                    tally.samples == count_of(plan, block) &&
                    tally.conclusions.size() == plan.targets[block.first].claim.conclusions.size();
  if (!fits) {
    throw InputError(plan.log.string() + ": target " + std::to_string(block.first) + ", first " +
                     std::to_string(block.second) + " is no block of this campaign");
  }
}

}  // namespace

std::uint64_t block_size(const CampaignPlan& plan, const Target& target) {
  const std::uint64_t cost = std::max<std::uint64_t>(1, instance_class(target.claim.instance).cost(target.shape));
  return std::max({std::uint64_t{1}, plan.block / cost, target.samples / most_blocks});
}

std::vector<Tally> run_campaign(const CampaignPlan& plan, const Progress& progress) {
  CampaignLog log(plan.log, plan_identity(plan));
  for (const auto& [block, tally] : log.finished()) require_of_plan(plan, block, tally);
  std::vector<Block> missing;
  std::uint64_t total = 0;
  std::uint64_t done_before = 0;
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    const std::uint64_t samples = plan.targets[target].samples;
    total += samples;
    for (std::uint64_t first = 0; first < samples; first += block_size(plan, plan.targets[target])) {
      if (log.finished().contains({target, first})) {
        done_before += count_of(plan, {target, first});
      } else {
        missing.emplace_back(target, first);
      }
    }
  }
  std::map<Block, Tally> blocks = log.finished();
  // The claims' functions live in it: made before the threads ask for it.
  (void)full_vocabulary();
  std::mutex mutex;
  std::atomic<std::uint64_t> done = done_before;
  const Job job = [&](std::size_t number, const std::atomic<bool>&) {
    const Block& block = missing[number];
    Tally tally = attack(plan, block);
    const std::scoped_lock lock(mutex);
    log.append(block, tally);
    done += tally.samples;
    blocks[block] = std::move(tally);
  };
  run_jobs(missing.size(), plan.threads, job, [&] { progress("attack", done, total); });
  std::vector<Tally> result(plan.targets.size());
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    result[target].conclusions.resize(plan.targets[target].claim.conclusions.size());
  }
  for (const auto& [block, tally] : blocks) result[block.first].add(tally);
  return result;
}

}  // namespace delcert
