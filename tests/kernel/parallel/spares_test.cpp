#include "kernel/parallel/spares.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

struct Tool {
  std::atomic<int> users = 0;
  int uses = 0;
};

TEST(Spares, are_used_again) {
  Spares<Tool> spares;
  int made = 0;
  const auto make = [&] {
    ++made;
    return std::make_unique<Tool>();
  };
  const auto use = [](Tool& tool) { return ++tool.uses; };
  EXPECT_EQ(spares.with(make, use), 1);
  EXPECT_EQ(spares.with(make, use), 2);
  const int inner = spares.with(make, [&](Tool&) { return spares.with(make, use); });
  EXPECT_EQ(inner, 1) << "the first is in use";
  EXPECT_EQ(made, 2);
}

TEST(Spares, are_given_up_where_work_fails) {
  Spares<Tool> spares;
  const auto make = [] { return std::make_unique<Tool>(); };
  EXPECT_THROW(spares.with(make,
                           [](Tool& tool) {
                             ++tool.uses;
                             if (tool.uses > 0) throw std::runtime_error("no");
                             return 0;
                           }),
               std::runtime_error);
  EXPECT_EQ(spares.with(make, [](const Tool& tool) { return tool.uses; }), 0);
}

TEST(Spares, have_one_user_at_a_time) {
  Spares<Tool> spares;
  std::atomic<int> made = 0;
  std::atomic<bool> is_shared = false;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&] {
      for (int round = 0; round < 1000; ++round) {
        (void)spares.with(
            [&] {
              ++made;
              return std::make_unique<Tool>();
            },
            [&](Tool& tool) {
              if (++tool.users != 1) is_shared = true;
              --tool.users;
              return 0;
            });
      }
    });
  }
  for (auto& thread : threads) thread.join();
  EXPECT_FALSE(is_shared);
  EXPECT_GE(made, 1);
  EXPECT_LE(made, 4);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
