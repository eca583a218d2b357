#include "properties/attack/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <delcert_version.hpp>
#include <exception>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>

#include "kernel/error.hpp"
#include "kernel/number/exact_text.hpp"
#include "properties/attack/campaign_log.hpp"

namespace delcert {

namespace {

using Block = CampaignLog::Block;

constexpr std::uint64_t most_blocks = 20000;
constexpr std::size_t most_threads = 256;

/// FNV-1a in 64 bits.
std::uint64_t digest_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return hash;
}

std::string contents_of(const Target& target) {
  std::string result = target.claim.name + "\n" + target.claim.instance + "\n" + std::to_string(target.shape.k) + " " +
                       std::to_string(target.shape.m) + " " + std::to_string(target.samples) + "\n";
  for (const auto& [name, range] : target.claim.parameters) {
    result += name + (range.has_lower ? " [" : " (") + exact_text(range.lower) + ", " + exact_text(range.upper) +
              (range.has_upper ? "]\n" : ")\n");
  }
  for (const Hypothesis& hypothesis : target.claim.hypotheses) result += "given " + hypothesis.text + "\n";
  for (const Conclusion& conclusion : target.claim.conclusions) {
    result += "show " + conclusion.name + " " + conclusion.text + "\n";
  }
  return result;
}

/// Everything on which the result depends.
std::string identity_of(const CampaignPlan& plan) {
  std::string contents;
  for (const Target& target : plan.targets) {
    contents += contents_of(target) + std::to_string(block_size(plan, target)) + "\n";
  }
  return std::string("delcert ") + version + ", seed " + std::to_string(plan.seed) + ", " +
         std::to_string(plan.targets.size()) + " targets, digest " + std::to_string(digest_of(contents));
}

std::string name_of(const Target& target) {
  return target.claim.name + " (k=" + std::to_string(target.shape.k) + ", m=" + std::to_string(target.shape.m) + ")";
}

/// The samples of a block.
std::uint64_t count_of(const CampaignPlan& plan, const Block& block) {
  const Target& target = plan.targets[block.first];
  return std::min(block_size(plan, target), target.samples - block.second);
}

class Workers {
 public:
  /// Precondition: all three outlive it.
  Workers(const CampaignPlan& plan, const std::vector<Block>& blocks, CampaignLog& log)
      : plan_(plan), blocks_(blocks), log_(log) {
    const std::size_t wanted = std::clamp<std::size_t>(plan.threads, 1, most_threads);
    for (std::size_t thread = 0; thread < std::min(wanted, blocks_.size()); ++thread) {
      try {
        threads_.emplace_back([this] { work(); });
      } catch (const std::system_error&) {
        // The system has no more: fewer do the same.
        if (threads_.empty()) throw;
        break;
      }
    }
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers() { stop(); }

  /// Waits until all is done, reporting how many samples are; rethrows what a worker threw.
  std::map<Block, Tally> wait(const std::function<void(std::uint64_t)>& report) {
    std::unique_lock lock(mutex_);
    while (finished_.size() < blocks_.size() && failures_.empty()) {
      changed_.wait_for(lock, std::chrono::milliseconds(100));
      const std::uint64_t done = samples_done_;
      lock.unlock();
      report(done);
      lock.lock();
    }
    if (failures_.empty()) return std::move(finished_);
    lock.unlock();
    // Blocks are begun in order: once all threads have ended, the first failure does not depend on their number.
    stop();
    std::rethrow_exception(failures_.begin()->second);
  }

 private:
  void stop() {
    stop_ = true;
    for (std::thread& thread : threads_) {
      if (thread.joinable()) thread.join();
    }
  }

  void work() {
    while (!stop_) {
      const std::size_t at = next_++;
      if (at >= blocks_.size()) return;
      try {
        Tally tally = attack(blocks_[at]);
        const std::scoped_lock lock(mutex_);
        log_.append(blocks_[at], tally);
        samples_done_ += tally.samples;
        finished_[blocks_[at]] = std::move(tally);
      } catch (...) {
        const std::scoped_lock lock(mutex_);
        failures_[at] = std::current_exception();
        stop_ = true;
      }
      changed_.notify_one();
    }
  }

  [[nodiscard]] Tally attack(const Block& block) const {
    const Target& target = plan_.targets[block.first];
    try {
      return attack_block(target.claim, target.shape, plan_.seed, block.second, count_of(plan_, block));
    } catch (const InputError& error) {
      throw InputError(name_of(target) + ": " + error.what());
    }
  }

  const CampaignPlan& plan_;
  const std::vector<Block>& blocks_;
  CampaignLog& log_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<Block, Tally> finished_;
  std::uint64_t samples_done_ = 0;
  std::map<std::size_t, std::exception_ptr> failures_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stop_ = false;
  std::vector<std::thread> threads_;
};

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
  CampaignLog log(plan.log, identity_of(plan));
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
  {
    Workers workers(plan, missing, log);
    blocks.merge(workers.wait([&](std::uint64_t done) { progress("attack", done_before + done, total); }));
  }
  std::vector<Tally> result(plan.targets.size());
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    result[target].conclusions.resize(plan.targets[target].claim.conclusions.size());
  }
  for (const auto& [block, tally] : blocks) result[block.first].add(tally);
  return result;
}

}  // namespace delcert
