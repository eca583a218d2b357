#include "support/utf8.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace {

using Code = std::pair<std::size_t, std::uint32_t>;

TEST(Utf8, reads_code_points_of_all_lengths) {
  EXPECT_EQ(first_code_point("ab"), Code(1, 'a'));
  EXPECT_EQ(first_code_point("\xc2\xb2z"), Code(2, 0xb2));
  EXPECT_EQ(first_code_point("\xe2\x84\x9d"), Code(3, 0x211d));
  EXPECT_EQ(first_code_point("\xf0\x9f\x98\x80"), Code(4, 0x1f600));
}

TEST(Utf8, takes_one_byte_of_what_is_none) {
  for (const char* broken : {"\x9b", "\xc2", "\xc1\x80", "\xe2\x84", "\xe2\x28\xa1", "\xff", "\xf5\x80\x80\x80"})
    EXPECT_EQ(first_code_point(broken), Code(1, 0xfffd)) << broken;
}

}  // namespace
}  // namespace delcert
