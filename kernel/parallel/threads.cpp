#include "kernel/parallel/threads.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <stdexcept>
#include <string>

#include "kernel/number/filter.hpp"
#include "kernel/number/self_test.hpp"

namespace delcert {

namespace {

unsigned processors() { return static_cast<unsigned>(tbb::info::default_concurrency()); }

/// That with the least limit of those alive.
std::atomic<ThreadLimit::State*> current = nullptr;

}  // namespace

struct ThreadLimit::State {
  explicit State(unsigned wanted)
      : threads(wanted > 0 ? wanted : processors()),
        control(tbb::global_control::max_allowed_parallelism, threads),
        arena(static_cast<int>(threads)),
        outer(current.load()) {}

  unsigned threads;
  tbb::global_control control;  // lets there be more threads than processors
  tbb::task_arena arena;
  State* outer;
};

ThreadLimit::ThreadLimit(unsigned threads) : state_(std::make_unique<State>(threads)) {
  if (state_->outer == nullptr || state_->threads < state_->outer->threads) current = state_.get();
}

ThreadLimit::~ThreadLimit() {
  if (current.load() == state_.get()) current = state_->outer;
}

unsigned thread_limit() {
  const ThreadLimit::State* limit = current.load();
  return limit != nullptr ? limit->threads : processors();
}

void run_parts(std::size_t count, const std::function<void(std::size_t)>& part) {
  ThreadLimit::State* const limit = current.load();
  if (count <= 1 || thread_limit() == 1) {
    for (std::size_t at = 0; at < count; ++at) part(at);
    return;
  }
  // oneTBB orders memory as is needed, but in a library that ThreadSanitizer does not see into; these two say so again.
  std::atomic<bool> started = false;
  std::atomic<std::size_t> finished = 0;
  const auto loop = [&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          (void)started.load(std::memory_order_acquire);
          for (std::size_t at = range.begin(); at < range.end(); ++at) part(at);
          finished.fetch_add(range.size(), std::memory_order_release);
        },
        tbb::simple_partitioner());
  };
  started.store(true, std::memory_order_release);
  if (limit != nullptr) {
    limit->arena.execute(loop);
  } else {
    loop();
  }
  (void)finished.load(std::memory_order_acquire);
}

void require_fit_thread() {
  // Without intervals nothing is certified, and nothing has to be fit for it.
  thread_local bool is_fit = !filter_is_rigorous;
  if (is_fit) return;
  const auto failures = arithmetic_self_test();
  if (!failures.empty()) throw std::runtime_error("a thread is not fit to certify: " + failures.front());
  is_fit = true;
}

}  // namespace delcert
