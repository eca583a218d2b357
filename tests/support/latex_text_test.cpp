#include "support/latex_text.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace {

TEST(LatexText, sets_what_latex_takes_for_commands) {
  EXPECT_EQ(latex_text("torus-2"), "torus-2");
  EXPECT_EQ(latex_text("a_b & 5% of {#1} $x$"), "a\\_b \\& 5\\% of \\{\\#1\\} \\$x\\$");
  EXPECT_EQ(latex_text("\\input~^"), "\\textbackslash{}input\\~{}\\^{}");
}

TEST(LatexText, names_what_fonts_may_lack) {
  EXPECT_EQ(latex_text("\xe4\xb8\xad"), "U+4E2D");
  EXPECT_EQ(latex_text("a\nb\x1b"), "aU+000AbU+001B");
  EXPECT_EQ(latex_text("\xff"), "U+FFFD");
}

TEST(LatexText, sets_letters_of_mathematics) {
  EXPECT_EQ(latex_text("S\xc2\xb2"), "S$^2$");
  EXPECT_EQ(latex_text("\xce\xbc\xe2\x82\x80 \xe2\x89\xa4 1"), "$\\mu$$_0$ $\\le$ 1");
}

TEST(LatexText, breaks_words_into_groups) {
  EXPECT_EQ(latex_breakable("0123456", 3), "012\\allowbreak 345\\allowbreak 6");
  EXPECT_EQ(latex_breakable("012", 3), "012");
  EXPECT_EQ(latex_breakable("", 3), "");
  EXPECT_EQ(latex_breakable("\xe4\xb8\xad\xe4\xb8\xad", 1), "U+4E2D\\allowbreak U+4E2D");
}

}  // namespace
}  // namespace delcert
