#include "kernel/parallel/parts.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "kernel/number/interval.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

constexpr std::size_t count = 3001;  // several rounds, the last part not full

void dawdle(std::size_t number) { std::this_thread::sleep_for(std::chrono::microseconds(number % 7 == 0 ? 100 : 0)); }

TEST(InParts, takes_what_was_found_in_order_whatever_the_number_of_threads) {
  for (const unsigned limit : {1U, 2U, 4U}) {
    const ThreadLimit threads(limit);
    std::vector<std::size_t> taken;
    const auto here = std::this_thread::get_id();
    in_parts(
        "count", count, no_progress(),
        [](std::size_t first, std::size_t last) {
          std::vector<std::size_t> found;
          for (std::size_t at = first; at < last; ++at) found.push_back(at * at);
          dawdle(first);
          return found;
        },
        [&](const std::vector<std::size_t>& found) {
          EXPECT_EQ(std::this_thread::get_id(), here);
          taken.insert(taken.end(), found.begin(), found.end());
        });
    ASSERT_EQ(taken.size(), count);
    for (std::size_t at = 0; at < count; ++at) EXPECT_EQ(taken[at], at * at);
  }
}

TEST(InParts, asks_for_nothing_where_there_is_nothing_to_do) {
  in_parts(
      "nothing", 0, no_progress(),
      [](std::size_t, std::size_t) {
        ADD_FAILURE();
        return 0;
      },
      [](int) { ADD_FAILURE(); });
}

TEST(InParts, throws_the_first_exception_in_order_after_taking_what_comes_before) {
  for (const unsigned limit : {1U, 2U, 4U}) {
    const ThreadLimit threads(limit);
    std::size_t taken = 0;
    try {
      in_parts<4>(
          "fail", count, no_progress(),
          [](std::size_t first, std::size_t last) {
            // The later ones fail sooner.
            if (first < 1400) dawdle(0);
            for (std::size_t at = first; at < last; ++at) {
              if (at == 1402 || at == 1407 || at == 1500 || at == 2900) throw std::runtime_error(std::to_string(at));
            }
            return last;
          },
          [&taken](std::size_t last) { taken = last; });
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "1402");
    }
    EXPECT_EQ(taken, 1400U);
  }
}

TEST(InParts, reports_progress_here_and_can_be_given_up_there) {
  const ThreadLimit threads(4);
  const auto here = std::this_thread::get_id();
  std::vector<std::size_t> reported;
  std::atomic<std::size_t> done = 0;
  const auto work = [&done](std::size_t first, std::size_t last) { return done += last - first; };
  const auto take = [](std::size_t) {};
  in_parts(
      "work", count,
      [&](std::string_view stage, std::size_t at, std::size_t total) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        EXPECT_EQ(stage, "work");
        EXPECT_EQ(total, count);
        EXPECT_EQ(done.load(), at);
        reported.push_back(at);
      },
      work, take);
  EXPECT_EQ(reported.front(), 0U);
  EXPECT_EQ(reported.back(), count);
  EXPECT_GE(reported.size(), 3U);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  done = 0;
  const auto give_up = [](std::string_view, std::size_t at, std::size_t) {
    if (at > 0) throw std::domain_error("enough");
  };
  EXPECT_THROW(in_parts("work", count, give_up, work, take), std::domain_error);
  EXPECT_LT(done.load(), count);
}

TEST(InParts, rounds_to_nearest_in_every_thread_before_and_after_intervals) {
  for (const unsigned limit : {1U, 4U}) {
    const ThreadLimit threads(limit);
    std::size_t wrong = 0;
    in_parts(
        "round", count, no_progress(),
        [](std::size_t first, std::size_t last) {
          std::size_t found = std::fegetround() == FE_TONEAREST ? 0 : 1;
          const auto divisor = static_cast<int>(3 * (first + last) + 1);
          {
            const RoundingGuard guard;
            const Interval quotient = Interval(1) / Interval(divisor);
            if (!(quotient.lower() < quotient.upper()) && (divisor & (divisor - 1)) != 0) ++found;
            const Interval product = quotient * Interval(divisor);
            if (!(product.lower() <= 1 && 1 <= product.upper())) ++found;
          }
          if (std::fegetround() != FE_TONEAREST) ++found;
          return found;
        },
        [&wrong](std::size_t found) { wrong += found; });
    EXPECT_EQ(wrong, 0U);
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  }
}

TEST(InParts, works_with_the_precision_of_this_thread_and_counts_decisions_here) {
  for (const unsigned limit : {1U, 4U}) {
    const ThreadLimit threads(limit);
    const BigInterval::Precision precision(PrecisionBits{300});
    const LadderStatistics before = ladder_statistics();
    std::size_t other = 0;
    in_parts(
        "decide", count, no_progress(),
        [](std::size_t first, std::size_t last) {
          ladder_statistics().count(Rung::big_interval, last - first);
          if (first == 0) ++ladder_statistics().undecided;
          return BigInterval::working_precision() == PrecisionBits{300} ? 0U : 1U;
        },
        [&other](unsigned found) { other += found; });
    EXPECT_EQ(other, 0U);
    const LadderStatistics counted = ladder_statistics() - before;
    EXPECT_EQ(counted.settled[static_cast<std::size_t>(Rung::big_interval)], count);
    EXPECT_EQ(counted.undecided, 1U);
    EXPECT_EQ(counted.total(), count + 1);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
