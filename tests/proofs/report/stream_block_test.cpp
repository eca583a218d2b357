#include "proofs/report/stream_block.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/proofs/report/unpacked.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::from_codes;
using test::from_planes;
using test::from_varints;
using test::stream_of;
using test::unpacked;

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

RC_GTEST_PROP(StreamBlock, gives_back_what_it_was_given, (const std::vector<std::uint32_t>& numbers)) {
  StreamBlock block;
  const auto first = block.add_varints(numbers), second = block.add_varints(numbers);
  const std::string bytes = unpacked(block.base64());
  RC_ASSERT(from_varints(stream_of(bytes, first)) == numbers);
  RC_ASSERT(from_varints(stream_of(bytes, second)) == numbers);
  RC_ASSERT(second.at("offset") == first.at("bytes"));
}

TEST(StreamBlock, rounds_floats_to_the_nearest_and_keeps_lines) {
  StreamBlock block;
  const auto floats = block.add_floats({0.1, -2.5, 1e300, 0});
  const auto lines = block.add_lines({"1/3 2", "", "-0x3p-5 7"});
  const std::string bytes = unpacked(block.base64());
  const auto bits = from_planes(stream_of(bytes, floats), 4);
  ASSERT_EQ(bits.size(), 4U);
  EXPECT_EQ(std::bit_cast<float>(bits[0]), 0.1F);
  EXPECT_EQ(std::bit_cast<float>(bits[1]), -2.5F);
  EXPECT_TRUE(std::isinf(std::bit_cast<float>(bits[2])));
  EXPECT_EQ(stream_of(bytes, lines), "1/3 2\n\n-0x3p-5 7");
}

TEST(StreamBlock, rounds_measures_by_half_a_step_at_most) {
  const std::vector<double> positive{0.001, 0.0017, not_measured, 0.5, 3}, with_zero{-1, 0, not_measured, 0.25, 3};
  for (const std::size_t width : {std::size_t{1}, std::size_t{2}}) {
    for (const auto& numbers : {positive, with_zero}) {
      StreamBlock block;
      const auto entry = block.add_codes(numbers, width);
      EXPECT_EQ(entry.at("scale"), numbers[0] > 0 ? "ratios" : "differences");
      const auto back = from_codes(stream_of(unpacked(block.base64()), entry), entry);
      ASSERT_EQ(back.size(), numbers.size());
      const double steps = width == 2 ? 65534 : 254;
      for (std::size_t at = 0; at < numbers.size(); ++at) {
        if (std::isnan(numbers[at])) {
          EXPECT_TRUE(std::isnan(back[at]));
          continue;
        }
        const double error = numbers[0] > 0 ? std::fabs(std::log(back[at] / numbers[at])) / std::log(3000.0)
                                            : std::fabs(back[at] - numbers[at]) / 4;
        EXPECT_LE(error, 0.5001 / steps) << at;
      }
      EXPECT_NEAR(back.front(), numbers.front(), 1e-12);
      EXPECT_NEAR(back.back(), numbers.back(), 1e-12);
    }
  }
}

TEST(StreamBlock, has_codes_for_one_value_and_for_none) {
  StreamBlock block;
  const auto one = block.add_codes({2, 2}, 2), none = block.add_codes({not_measured}, 1);
  const std::string bytes = unpacked(block.base64());
  EXPECT_EQ(from_codes(stream_of(bytes, one), one), (std::vector<double>{2, 2}));
  EXPECT_TRUE(std::isnan(from_codes(stream_of(bytes, none), none).at(0)));
}

RC_GTEST_PROP(StreamBlock, columns_make_up_the_rows_again, ()) {
  auto rows = *rc::gen::container<std::vector<std::vector<std::uint32_t>>>(
      rc::gen::container<std::vector<std::uint32_t>>(3, rc::gen::inRange<std::uint32_t>(0, 6)));
  for (auto& row : rows) std::sort(row.begin(), row.end());
  std::sort(rows.begin(), rows.end());
  const auto columns = columns_of_sorted_rows(rows);
  std::vector<std::vector<std::uint32_t>> back;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    bool same = row > 0;
    std::vector<std::uint32_t> own;
    for (std::size_t column = 0; column < 3; ++column) {
      own.push_back((same ? back[row - 1][column] : column > 0 ? own[column - 1] : 0) + columns[column][row]);
      same = same && columns[column][row] == 0;
    }
    back.push_back(own);
  }
  RC_ASSERT(back == rows);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
