#include "kernel/parallel/threads.hpp"

#include <gtest/gtest.h>
#include <xmmintrin.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The threads that some short parts were done in, and how often each part was.
struct Done {
  explicit Done(std::size_t count) : times(count) {
    run_parts(count, [this](std::size_t part) {
      ++times[part];
      const unsigned now = ++at_once;
      std::this_thread::sleep_for(std::chrono::microseconds(50));
      const std::scoped_lock lock(mutex);
      threads.insert(std::this_thread::get_id());
      most_at_once = std::max(most_at_once, now);
      --at_once;
    });
  }

  std::vector<std::atomic<int>> times;
  std::atomic<unsigned> at_once = 0;
  unsigned most_at_once = 0;
  std::set<std::thread::id> threads;
  std::mutex mutex;
};

TEST(RunParts, does_each_once_whatever_the_limit) {
  for (const unsigned limit : {1U, 2U, 4U}) {
    const ThreadLimit threads(limit);
    for (const std::size_t count : {0U, 1U, 2U, 7U, 200U}) {
      const Done done(count);
      for (const auto& times : done.times) EXPECT_EQ(times.load(), 1);
    }
  }
}

TEST(RunParts, takes_no_more_threads_than_the_limit) {
  EXPECT_GE(thread_limit(), 1U);
  for (const unsigned limit : {1U, 2U, 3U}) {
    const ThreadLimit threads(limit);
    EXPECT_EQ(thread_limit(), limit);
    const Done done(200);
    EXPECT_LE(done.most_at_once, limit);
    EXPECT_GE(done.threads.size(), 1U);
  }
}

TEST(RunParts, takes_several_threads_even_where_there_are_fewer_processors) {
  const ThreadLimit threads(4);
  // Every part waits for the three others; in one thread, it would in vain.
  std::atomic<int> arrived = 0;
  std::atomic<int> met = 0;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(5);
  run_parts(4, [&](std::size_t) {
    ++arrived;
    while (arrived < 4 && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (arrived == 4) ++met;
  });
  EXPECT_EQ(met.load(), 4);
}

TEST(RunParts, in_one_thread_goes_in_order_in_this_one) {
  const ThreadLimit threads(1);
  std::vector<std::size_t> order;
  const auto here = std::this_thread::get_id();
  run_parts(50, [&](std::size_t part) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    order.push_back(part);
  });
  for (std::size_t part = 0; part < 50; ++part) EXPECT_EQ(order[part], part);
}

TEST(ThreadLimit, of_several_the_least_holds_until_it_ends) {
  const unsigned without = thread_limit();
  {
    const ThreadLimit four(4);
    EXPECT_EQ(thread_limit(), 4U);
    {
      const ThreadLimit two(2);
      EXPECT_EQ(thread_limit(), 2U);
      const ThreadLimit eight(8);
      EXPECT_EQ(thread_limit(), 2U);
      EXPECT_LE(Done(100).most_at_once, 2U);
    }
    EXPECT_EQ(thread_limit(), 4U);
  }
  EXPECT_EQ(thread_limit(), without);
  const ThreadLimit all(0);
  EXPECT_EQ(thread_limit(), without);
}

TEST(RequireFitThread, refuses_a_thread_that_takes_small_numbers_for_zero) {
  EXPECT_NO_THROW(require_fit_thread());
  std::string complaint;
  std::thread([&complaint] {
    constexpr unsigned flush_to_zero = 0x8000;
    _mm_setcsr(_mm_getcsr() | flush_to_zero);
    try {
      require_fit_thread();
    } catch (const std::runtime_error& error) {
      complaint = error.what();
    }
  }).join();
  EXPECT_EQ(complaint, "a thread is not fit to certify: results below the normal numbers are flushed to zero");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
