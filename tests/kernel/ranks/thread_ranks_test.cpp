#include "kernel/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "support/error.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(RanksInThreads, get_what_was_sent_to_them) {
  run_ranks_in_threads(4, [](Communicator& ranks) {
    EXPECT_EQ(ranks.size(), 4U);
    for (int round = 0; round < 100; ++round) {
      std::vector<Message> messages;
      for (std::size_t to = 0; to < 4; ++to)
        messages.push_back(std::to_string(ranks.rank()) + ">" + std::to_string(to) + " " + std::to_string(round));
      const auto received = ranks.exchange(std::move(messages));
      ASSERT_EQ(received.size(), 4U);
      for (std::size_t from = 0; from < 4; ++from)
        EXPECT_EQ(received[from],
                  std::to_string(from) + ">" + std::to_string(ranks.rank()) + " " + std::to_string(round));
    }
  });
}

TEST(RanksInThreads, end_together_where_one_throws) {
  std::atomic<int> ended = 0;
  const auto work = [&](Communicator& ranks) {
    (void)gather_everywhere(ranks, {});
    if (ranks.rank() == 2) throw Rejection("this one");
    try {
      (void)gather_everywhere(ranks, {});
    } catch (...) {
      ++ended;
      throw;
    }
  };
  EXPECT_THROW(run_ranks_in_threads(4, work), Rejection);
  EXPECT_EQ(ended, 3);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
