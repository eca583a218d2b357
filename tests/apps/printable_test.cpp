#include "apps/printable.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace {

TEST(PrintableText, stays_as_it_is_but_for_what_moves_a_terminal) {
  for (const char* text : {"", "torus-2", "S\xc2\xb2 \xc3\x97 S\xc2\xb9", "\xe2\x84\x9d\xc2\xb3", "\xf0\x9f\x98\x80"})
    EXPECT_EQ(printable(text), text);
  EXPECT_EQ(printable("a\x1b[2Jb\n"), "a\\u001b[2Jb\\u000a");
  EXPECT_EQ(printable("\xc2\x9b\xc2\x80\x7f"), "\\u009b\\u0080\\u007f");
  EXPECT_EQ(printable("\xe2\x80\xae\xef\xbb\xbf"), "\\u202e\\ufeff");
}

TEST(PrintableText, has_no_byte_that_is_not_utf_8) {
  EXPECT_EQ(printable("a\x9b"
                      "b"),
            "a\\ufffdb");
  EXPECT_EQ(printable("\xc2"), "\\ufffd");
  EXPECT_EQ(printable("\xe2\x84"), "\\ufffd\\ufffd");
}

}  // namespace
}  // namespace delcert
