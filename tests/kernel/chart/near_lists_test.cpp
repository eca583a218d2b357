#include "kernel/chart/near_lists.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using List = std::vector<std::uint32_t>;

List list_of(std::uint32_t label) { return {label, label + 1}; }

TEST(NearLists, makes_a_list_once) {
  NearLists<List> lists(10, 1000);
  int made = 0;
  const auto make = [&made] {
    ++made;
    return list_of(3);
  };
  const auto* first = lists.of(3, make);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->at(1), 4U);
  EXPECT_EQ(lists.of(3, make), first);
  EXPECT_EQ(made, 1);
  EXPECT_NE(lists.of(4, make), first);
}

TEST(NearLists, keeps_no_more_than_it_may) {
  NearLists<List> lists(10, 3);
  const auto make = [] { return list_of(0); };
  EXPECT_NE(lists.of(0, make), nullptr);
  EXPECT_NE(lists.of(1, make), nullptr);
  EXPECT_EQ(lists.of(2, make), nullptr);
  EXPECT_NE(lists.of(0, make), nullptr) << "what is there stays";
}

TEST(NearLists, are_the_same_for_all_threads) {
  constexpr std::uint32_t labels = 200;
  NearLists<List> lists(labels, 100000);
  std::vector<std::vector<const List*>> seen(4, std::vector<const List*>(labels));
  std::vector<std::thread> threads;
  for (auto& mine : seen) {
    threads.emplace_back([&] {
      for (std::uint32_t label = 0; label < labels; ++label)
        mine[label] = lists.of(label, [=] { return list_of(label); });
    });
  }
  for (auto& thread : threads) thread.join();
  for (std::uint32_t label = 0; label < labels; ++label) {
    EXPECT_EQ(seen[0][label]->front(), label);
    for (const auto& mine : seen) EXPECT_EQ(mine[label], seen[0][label]);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
