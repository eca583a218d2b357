#include "kernel/chart/cell_table.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(CellTable, has_what_was_put_in) {
  std::mt19937_64 random(1);
  CellTable table;
  std::map<std::uint64_t, std::uint32_t> expected;
  for (std::uint32_t number = 0; number < 20000; ++number) {
    // Keys in a row, keys far apart, and 0.
    const std::uint64_t key = number % 2 == 0 ? number / 3 : random() >> (random() % 60);
    std::uint32_t& there = table.at(key);
    EXPECT_EQ(there, expected.contains(key) ? expected[key] : CellTable::none);
    there = number;
    expected[key] = number;
  }
  for (const auto& [key, number] : expected) EXPECT_EQ(table.find(key), number);
  for (int at = 0; at < 10000; ++at) {
    const std::uint64_t key = random();
    EXPECT_EQ(table.find(key), expected.contains(key) ? expected[key] : CellTable::none);
  }
}

TEST(CellTable, that_is_empty_has_nothing) {
  const CellTable table;
  EXPECT_EQ(table.find(0), CellTable::none);
  EXPECT_EQ(table.find(~std::uint64_t{0}), CellTable::none);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
