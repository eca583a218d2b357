#include "properties/attack/job_pool.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

namespace delcert {
namespace DELCERT_THIS_FILE {

using namespace std::chrono_literals;

const std::function<void()> no_report = [] {};

TEST(JobPool, every_job_is_done_once_whatever_the_threads) {
  for (const unsigned threads : {0U, 1U, 2U, 7U, 100000U}) {
    std::mutex mutex;
    std::multiset<std::size_t> done;
    run_jobs(
        50, threads,
        [&](std::size_t number, const std::atomic<bool>&) {
          const std::scoped_lock lock(mutex);
          done.insert(number);
        },
        no_report);
    EXPECT_EQ(done.size(), 50U);
    EXPECT_EQ(std::set<std::size_t>(done.begin(), done.end()).size(), 50U);
    EXPECT_EQ(*done.rbegin(), 49U);
  }
}

TEST(JobPool, no_jobs_end_at_once) {
  run_jobs(
      0, 4, [](std::size_t, const std::atomic<bool>&) { FAIL(); }, no_report);
}

TEST(JobPool, the_first_failure_in_order_arrives_and_no_more_jobs_are_begun) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    std::atomic<std::size_t> begun = 0;
    try {
      run_jobs(
          100000, threads,
          [&](std::size_t number, const std::atomic<bool>&) {
            ++begun;
            // The later one fails sooner.
            if (number == 20) std::this_thread::sleep_for(20ms);
            if (number == 20 || number == 21) throw std::runtime_error(std::to_string(number));
          },
          no_report);
      FAIL();
    } catch (const std::runtime_error& failure) {
      EXPECT_STREQ(failure.what(), "20") << threads;
    }
    EXPECT_GE(begun, 21U);
    EXPECT_LT(begun, 100000U);
    if (threads == 1) {
      EXPECT_EQ(begun, 21U);
    }
  }
}

TEST(JobPool, what_the_report_throws_arrives_and_jobs_are_told_to_stop) {
  std::atomic<std::size_t> stopped = 0;
  const Job until_stopped = [&](std::size_t, const std::atomic<bool>& stopping) {
    while (!stopping) std::this_thread::sleep_for(1ms);
    ++stopped;
    throw std::logic_error("of no interest any more");
  };
  const auto interrupt = [] { throw std::runtime_error("interrupted"); };
  try {
    run_jobs(10, 3, until_stopped, interrupt);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "interrupted");
  }
  EXPECT_LE(stopped, 3U);
}

TEST(JobPool, the_report_comes_from_the_calling_thread) {
  const auto caller = std::this_thread::get_id();
  std::size_t reports = 0;
  run_jobs(
      2, 2, [](std::size_t, const std::atomic<bool>&) { std::this_thread::sleep_for(150ms); },
      [&] {
        ++reports;
        EXPECT_EQ(std::this_thread::get_id(), caller);
      });
  EXPECT_GE(reports, 1U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
