#include "support/text_table.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(TextTable, aligns_columns_and_leaves_no_blanks_at_the_end) {
  EXPECT_EQ(text_table({{"a", "bb", "c"}, {"aaa", "b", ""}}), "a    bb  c\naaa  b\n");
  EXPECT_EQ(text_table({}), "");
  EXPECT_EQ(text_table({{"", ""}, {"x"}}), "\nx\n");
}

TEST(TextTable, counts_letters_and_neither_bytes_nor_marks) {
  EXPECT_EQ(width_of("abc"), 3U);
  EXPECT_EQ(width_of("μ₀′"), 3U);
  EXPECT_EQ(width_of("ρ̃₀"), 2U);
  EXPECT_EQ(text_table({{"ρ̃₀", "x"}, {"ab", "x"}}), "ρ̃₀  x\nab  x\n");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
