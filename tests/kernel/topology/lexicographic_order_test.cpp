#include "kernel/topology/lexicographic_order.hpp"

#include <gtest/gtest.h>

#include <array>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(LexicographicOrder, IsThatOfAStableSort) {
  std::vector<std::array<std::size_t, 3>> keys;
  for (std::size_t at = 0; at < 200; ++at) keys.push_back({at * at % 7, at * 5 % 3, at * at * at % 4});
  std::vector<std::size_t> expected(keys.size());
  std::iota(expected.begin(), expected.end(), std::size_t{0});
  std::stable_sort(expected.begin(), expected.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  const auto key = [&](std::size_t entry, std::size_t place) { return keys[entry][place]; };
  EXPECT_EQ(lexicographic_order(keys.size(), 3, 7, key), expected);
  // By the first place alone it is another one.
  EXPECT_NE(lexicographic_order(keys.size(), 1, 7, key), expected);
}

TEST(LexicographicOrder, OfNothingIsEmpty) {
  EXPECT_TRUE(lexicographic_order(0, 2, 1, [](std::size_t, std::size_t) { return std::size_t{0}; }).empty());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
