#include "support/sort_by_number.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace delcert {
namespace DELCERT_THIS_FILE {

using Pair = std::pair<std::uint32_t, int>;

TEST(SortByNumber, does_what_sort_does) {
  std::mt19937 random(1);
  for (const std::uint32_t numbers : {1U, 3U, 50U, 400U}) {
    for (const std::size_t count : {0U, 1U, 2U, 100U}) {
      std::vector<Pair> values(count);
      for (Pair& value : values) value = {random() % numbers, static_cast<int>(random() % 5)};
      auto expected = values;
      std::sort(expected.begin(), expected.end());
      sort_by_number(values, [](const Pair& value) { return value.first; });
      EXPECT_EQ(values, expected);
    }
  }
}

TEST(SortByNumber, compares_only_what_shares_a_number) {
  std::vector<Pair> values{{7, 1}, {2, 5}, {7, 0}, {0, 3}, {2, 5}};
  int comparisons = 0;
  sort_by_number(
      values, [](const Pair& value) { return value.first; },
      [&comparisons](const Pair& a, const Pair& b) {
        EXPECT_EQ(a.first, b.first);
        ++comparisons;
        return a < b;
      });
  EXPECT_EQ(values, (std::vector<Pair>{{0, 3}, {2, 5}, {2, 5}, {7, 0}, {7, 1}}));
  EXPECT_GT(comparisons, 1);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
