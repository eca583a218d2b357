#include "proofs/checker/certificate/printable.hpp"

#include <gtest/gtest.h>

namespace delcert::checker_tests {
namespace {

using checker::printable;

TEST(Printable, text_stays_as_it_is) {
  for (const char* text : {"", "torus-2", "S\xc2\xb2 \xc3\x97 S\xc2\xb9", "\xe2\x84\x9d\xc2\xb3", "\xf0\x9f\x98\x80",
                           "\\u009b", "\\\"x\\\""})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, control_characters_stand_as_escape_sequences) {
  EXPECT_EQ(printable("a\x1b[2Jb"), "a\\u001b[2Jb");
  EXPECT_EQ(printable("a\nb"), "a\\u000ab");
  EXPECT_EQ(printable("\x7f"), "\\u007f");
  EXPECT_EQ(printable(std::string(1, '\0')), "\\u0000");
  EXPECT_EQ(printable("\xc2\x80\xc2\x9b\xc2\x9f\xc2\xa0"), "\\u0080\\u009b\\u009f\xc2\xa0");
  EXPECT_EQ(printable("\xe2\x80\xae\xe2\x81\xa6\xef\xbb\xbf"), "\\u202e\\u2066\\ufeff");
}

}  // namespace
}  // namespace delcert::checker_tests
