#include "properties/attack/job_pool.hpp"

#include <flint/flint.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace delcert {

namespace {

constexpr std::size_t most_threads = 256;

class Workers {
 public:
  /// Precondition: the job outlives it.
  Workers(std::size_t count, unsigned threads, const Job& job) : count_(count), job_(job) {
    const std::size_t wanted = std::clamp<std::size_t>(threads, 1, most_threads);
    for (std::size_t thread = 0; thread < std::min(wanted, count_); ++thread) {
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
  ~Workers() {
    stopping_ = true;
    join();
  }

  void wait(const std::function<void()>& report) {
    std::unique_lock lock(mutex_);
    while (ended_ < count_ && failures_.empty()) {
      changed_.wait_for(lock, std::chrono::milliseconds(100));
      lock.unlock();
      report();
      lock.lock();
    }
    if (failures_.empty()) return;
    lock.unlock();
    // Jobs are begun in order: once all threads have ended, the first failure does not depend on their number.
    join();
    std::rethrow_exception(failures_.begin()->second);
  }

 private:
  void join() {
    no_more_ = true;
    for (std::thread& thread : threads_) {
      if (thread.joinable()) thread.join();
    }
  }

  void work() {
    do_jobs();
    // What FLINT keeps for each thread would be lost with it.
    flint_cleanup();
  }

  void do_jobs() {
    while (!no_more_) {
      const std::size_t number = next_++;
      if (number >= count_) return;
      std::exception_ptr failure;
      try {
        job_(number, stopping_);
      } catch (...) {
        failure = std::current_exception();
      }
      {
        const std::scoped_lock lock(mutex_);
        ++ended_;
        if (failure) failures_[number] = failure;
      }
      if (failure) no_more_ = true;
      changed_.notify_one();
    }
  }

  std::size_t count_;
  const Job& job_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t ended_ = 0;
  std::map<std::size_t, std::exception_ptr> failures_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> no_more_ = false;
  std::atomic<bool> stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace

void run_jobs(std::size_t count, unsigned threads, const Job& job, const std::function<void()>& report) {
  Workers(count, threads, job).wait(report);
}

}  // namespace delcert
