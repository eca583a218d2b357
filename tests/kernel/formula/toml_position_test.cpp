#include "kernel/formula/toml_position.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/toml.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// The place of the letter X of the value of a = …, which toml++ reads, found in the text by its offset in the value.
TextPosition place_of_x(const std::string& text) {
  const toml::table table = toml::parse(text);
  const auto value = table["a"].value_exact<std::string>();
  const auto& begin = table.get("a")->source().begin;
  return position_in_toml_string(text, {begin.line, begin.column}, value->find('X'));
}

TEST(TomlPositions, plain_strings) {
  EXPECT_EQ(place_of_x("a = \"X\""), (TextPosition{1, 6}));
  EXPECT_EQ(place_of_x("a = \"12X4\""), (TextPosition{1, 8}));
  EXPECT_EQ(place_of_x("a = '12X4'"), (TextPosition{1, 8}));
  EXPECT_EQ(place_of_x("# comment\n\n  a =   'X'"), (TextPosition{3, 10}));
}

TEST(TomlPositions, escapes_are_longer_than_what_they_stand_for) {
  EXPECT_EQ(place_of_x(R"(a = "\t\"\\X")"), (TextPosition{1, 12}));
  EXPECT_EQ(place_of_x(R"(a = "\u0041X")"), (TextPosition{1, 12}));
  EXPECT_EQ(place_of_x(R"(a = "\u03b5\U0001F600X")"), (TextPosition{1, 22}));
  EXPECT_EQ(place_of_x(R"(a = "\u20acX")"), (TextPosition{1, 12}));
  EXPECT_EQ(place_of_x(R"(a = '\\X')"), (TextPosition{1, 8}));
}

TEST(TomlPositions, columns_count_characters) {
  EXPECT_EQ(place_of_x("a = \"\u03b5X\""), (TextPosition{1, 7}));
  EXPECT_EQ(place_of_x("\"\u03b5\u03b5\" = 1\nb = \"\u03b5\"\na = \"\U0001F600X\""), (TextPosition{3, 7}));
  EXPECT_EQ(place_of_x("\xEF\xBB\xBF"
                       "a = \"X\""),
            (TextPosition{1, 6}));
}

TEST(TomlPositions, a_string_later_on_a_line_with_other_characters_before) {
  const std::string text = "t = { b = \"\u03b5\u03b5\u03b5\", c = \"1X\" }";
  const toml::table table = toml::parse(text);
  const auto& begin = table["t"].as_table()->get("c")->source().begin;
  EXPECT_EQ(position_in_toml_string(text, {begin.line, begin.column}, 1), (TextPosition{1, 24}));
  EXPECT_EQ(text.substr(26, 1), "X");
}

TEST(TomlPositions, long_strings) {
  EXPECT_EQ(place_of_x("a = \"\"\"X\"\"\""), (TextPosition{1, 8}));
  EXPECT_EQ(place_of_x("a = \"\"\"\nX\"\"\""), (TextPosition{2, 1}));
  EXPECT_EQ(place_of_x("a = \"\"\"\r\n  X\"\"\""), (TextPosition{2, 3}));
  EXPECT_EQ(place_of_x("a = \"\"\"\n\n12\n  X\"\"\""), (TextPosition{4, 3}));
  EXPECT_EQ(place_of_x("a = \"\"\"12\r\n34\r\n  X\"\"\""), (TextPosition{3, 3}));
  EXPECT_EQ(place_of_x("a = '''\n12\n X'''"), (TextPosition{3, 2}));
  EXPECT_EQ(place_of_x("a = '''\\\nX'''"), (TextPosition{2, 1}));
}

TEST(TomlPositions, lines_joined_by_a_backslash) {
  EXPECT_EQ(place_of_x("a = \"\"\"12 \\\n   34 \\  \r\n\n  X\"\"\""), (TextPosition{4, 3}));
  EXPECT_EQ(place_of_x("a = \"\"\"\\\n   X\"\"\""), (TextPosition{2, 4}));
  EXPECT_EQ(place_of_x("a = \"\"\"\\\\\nX\"\"\""), (TextPosition{2, 1}));
}

TEST(TomlPositions, the_end_of_the_value_is_the_closing_quote) {
  EXPECT_EQ(position_in_toml_string("a = \"12\"", {1, 5}, 2), (TextPosition{1, 8}));
  EXPECT_EQ(position_in_toml_string("a = \"\"", {1, 5}, 0), (TextPosition{1, 6}));
  EXPECT_EQ(position_in_toml_string("a = '''\n12\n'''", {1, 5}, 3), (TextPosition{3, 1}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
