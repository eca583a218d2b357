#include "properties/attack/campaign.hpp"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "properties/attack/campaign_log.hpp"

namespace delcert {

namespace {

using Block = CampaignLog::Block;

/// Everything on which the result depends.
std::string identity_of(const CampaignPlan& plan) {
  std::string whole = "version 1, seed " + std::to_string(plan.seed) + ", blocks of " + std::to_string(plan.block);
  std::string contents;
  for (const Target& target : plan.targets) {
    contents += target.claim.name + " " + std::to_string(target.shape.k) + " " + std::to_string(target.shape.m) + " " +
                std::to_string(target.samples) + "\n";
    for (const Hypothesis& hypothesis : target.claim.hypotheses) contents += hypothesis.text + "\n";
    for (const Conclusion& conclusion : target.claim.conclusions) contents += conclusion.text + "\n";
  }
  return whole + ", claims " + std::to_string(stream_of(contents)) + ", " + std::to_string(plan.targets.size()) +
         " targets";
}

class Workers {
 public:
  Workers(const CampaignPlan& plan, std::vector<Block> blocks, CampaignLog& log)
      : plan_(plan), blocks_(std::move(blocks)), log_(log) {
    for (unsigned thread = 0; thread < std::max(1U, plan.threads); ++thread) threads_.emplace_back([this] { work(); });
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers() {
    stop_ = true;
    for (std::thread& thread : threads_) thread.join();
  }

  /// Waits until all is done, reporting how many samples are; rethrows what a worker threw.
  std::map<Block, Tally> wait(const std::function<void(std::uint64_t)>& report) {
    std::unique_lock lock(mutex_);
    while (finished_.size() < blocks_.size() && !failure_) {
      changed_.wait_for(lock, std::chrono::milliseconds(100));
      const std::uint64_t done = samples_done_;
      lock.unlock();
      report(done);
      lock.lock();
    }
    if (failure_) std::rethrow_exception(failure_);
    return finished_;
  }

 private:
  void work() {
    while (!stop_) {
      const std::size_t at = next_++;
      if (at >= blocks_.size()) return;
      try {
        const auto& [target, first] = blocks_[at];
        const Target& what = plan_.targets[target];
        const std::uint64_t count = std::min(plan_.block, what.samples - first);
        Tally tally = attack_block(what.claim, what.shape, plan_.seed, first, count);
        const std::scoped_lock lock(mutex_);
        log_.append(blocks_[at], tally);
        samples_done_ += count;
        finished_[blocks_[at]] = std::move(tally);
      } catch (...) {
        const std::scoped_lock lock(mutex_);
        failure_ = std::current_exception();
        stop_ = true;
      }
      changed_.notify_one();
    }
  }

  const CampaignPlan& plan_;
  std::vector<Block> blocks_;
  CampaignLog& log_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<Block, Tally> finished_;
  std::uint64_t samples_done_ = 0;
  std::exception_ptr failure_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stop_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace

std::vector<Tally> run_campaign(const CampaignPlan& plan, const Progress& progress) {
  CampaignLog log(plan.log, identity_of(plan));
  std::vector<Block> missing;
  std::uint64_t total = 0;
  std::uint64_t done_before = 0;
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    const std::uint64_t samples = plan.targets[target].samples;
    total += samples;
    for (std::uint64_t first = 0; first < samples; first += plan.block) {
      if (log.finished().contains({target, first})) {
        done_before += std::min(plan.block, samples - first);
      } else {
        missing.emplace_back(target, first);
      }
    }
  }
  std::map<Block, Tally> blocks = log.finished();
  // The claims' functions live in it: made before the threads ask for it.
  (void)full_vocabulary();
  {
    Workers workers(plan, std::move(missing), log);
    blocks.merge(workers.wait([&](std::uint64_t done) { progress("attack", done_before + done, total); }));
  }
  std::vector<Tally> result(plan.targets.size());
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    result[target].conclusions.resize(plan.targets[target].claim.conclusions.size());
  }
  for (const auto& [block, tally] : blocks) {
    if (block.first < result.size()) result[block.first].add(tally);
  }
  return result;
}

}  // namespace delcert
