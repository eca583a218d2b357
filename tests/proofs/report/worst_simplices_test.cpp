#include "proofs/report/worst_simplices.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace delcert {
namespace DELCERT_THIS_FILE {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(WorstSimplices, come_first_and_equal_ones_in_their_order) {
  const std::vector<double> values{3, none, 1, 2, 1};
  EXPECT_EQ(worst_simplices(values, true), (std::vector<std::uint32_t>{2, 4, 3, 0}));
  EXPECT_EQ(worst_simplices(values, false), (std::vector<std::uint32_t>{0, 3, 2, 4}));
  EXPECT_TRUE(worst_simplices({none, none}, true).empty());
}

TEST(WorstSimplices, are_ten_at_most) {
  std::vector<double> values;
  for (int at = 0; at < 25; ++at) values.push_back((7 * at) % 25);
  const std::vector<std::uint32_t> worst = worst_simplices(values, true);
  ASSERT_EQ(worst.size(), worst_listed);
  for (std::size_t at = 0; at < worst.size(); ++at) EXPECT_EQ(values[worst[at]], static_cast<double>(at));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
