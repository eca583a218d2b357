#include "kernel/ranks/communicator.hpp"

#include <gtest/gtest.h>

#include "kernel/ranks/thread_ranks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(Ranks, gather_and_combine) {
  for (const std::size_t count : {1U, 2U, 5U}) {
    run_ranks_in_threads(count, [&](Communicator& ranks) {
      const std::string mine(1, static_cast<char>('a' + ranks.rank()));
      std::string everywhere;
      for (const Message& message : gather_everywhere(ranks, mine)) everywhere += message;
      EXPECT_EQ(everywhere, std::string("abcde").substr(0, count));
      std::string at_first;
      for (const Message& message : gather_at_first(ranks, mine)) at_first += message;
      EXPECT_EQ(at_first, ranks.rank() == 0 ? everywhere : "");
      EXPECT_EQ(of_first(ranks, mine), "a");
      // In the order of ranks: this is not commutative.
      EXPECT_EQ(combined_everywhere(ranks, static_cast<int>(ranks.rank()), [](int a, int b) { return 10 * a + b; }),
                std::vector<int>({0, 0, 1, 12, 123, 1234})[count]);
    });
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
