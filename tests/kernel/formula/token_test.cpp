#include "kernel/formula/token.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "kernel/formula/formula_error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::vector<std::string> texts(std::string_view formula) {
  std::vector<std::string> result;
  for (const Token& token : tokens_of(formula)) result.push_back(token.text);
  return result;
}

using Texts = std::vector<std::string>;

TEST(Tokens, numbers_words_and_symbols_are_told_apart) {
  EXPECT_EQ(texts("2*mu0<=(k-1)/m^2"), (Texts{"2", "*", "mu0", "<=", "(", "k", "-", "1", ")", "/", "m", "^", "2", ""}));
  EXPECT_EQ(texts("1..k"), (Texts{"1", "..", "k", ""}));
  EXPECT_EQ(texts("a<-b"), (Texts{"a", "<", "-", "b", ""}));
  EXPECT_EQ(texts("a>=b:c,d=e"), (Texts{"a", ">=", "b", ":", "c", ",", "d", "=", "e", ""}));
  EXPECT_EQ(texts(" \t\r\n"), (Texts{""}));
}

TEST(Tokens, each_knows_its_place) {
  const auto tokens = tokens_of("  ab <= 1");
  ASSERT_EQ(tokens.size(), 4U);
  EXPECT_EQ(tokens[0].offset, 2U);
  EXPECT_EQ(tokens[1].offset, 5U);
  EXPECT_EQ(tokens[2].offset, 8U);
  EXPECT_EQ(tokens[3].offset, 9U);
  EXPECT_EQ(tokens[3].kind, TokenKind::end);
  EXPECT_EQ(tokens[3].shown(), "the end");
  EXPECT_EQ(tokens[0].shown(), "'ab'");
}

TEST(Tokens, a_number_is_no_symbol) {
  EXPECT_FALSE(tokens_of("1")[0].is("1"));
  EXPECT_TRUE(tokens_of("and")[0].is("and"));
}

TEST(Tokens, what_begins_nothing_is_refused_where_it_stands) {
  const std::vector<std::pair<std::string, std::pair<std::size_t, std::string>>> cases{
      {"1.5", {1, "fraction"}},
      {"1.", {1, "fraction"}},
      {"a .5", {2, "fraction"}},
      {"2k", {1, "products are written with *"}},
      {"0x10", {1, "products are written with *"}},
      {"1e5", {1, "products are written with *"}},
      {"a == b", {2, "write ="}},
      {"a != b", {2, "write not (a = b)"}},
      {"a**2", {1, "write ^"}},
      {"a => b", {2, "write implies"}},
      {"a && b", {2, "write and"}},
      {"a || b", {2, "write or"}},
      {"a \u2264 b", {2, "write <="}},
      {"a \u2265 b", {2, "write >="}},
      {"\u2212a", {0, "write -"}},
      {"a\u00b2", {1, "write ^2"}},
      {"\u221a2", {0, "write sqrt(x)"}},
      {"a % b", {2, "the character '%' begins nothing"}},
      {"\u03b5", {0, "the character '\u03b5' begins nothing"}},
      {std::string("a\x07", 2), {1, "the character U+0007 begins nothing"}},
      {std::string("a\0b", 3), {1, "the character U+0000 begins nothing"}},
      {"\xff", {0, "begins nothing"}},
      {std::string(65, 'a'), {0, "more than 64 letters"}},
  };
  for (const auto& [text, expected] : cases) {
    try {
      (void)tokens_of(text);
      ADD_FAILURE() << text << " was accepted";
    } catch (const FormulaError& error) {
      EXPECT_EQ(error.offset(), expected.first) << text;
      EXPECT_NE(std::string(error.what()).find(expected.second), std::string::npos) << text << ": " << error.what();
    }
  }
}

TEST(Tokens, names_are_words_that_are_no_keywords) {
  for (const char* name : {"k", "mu0", "xi_tilde", "_", "android"}) EXPECT_TRUE(is_name_of_formula(name)) << name;
  for (const char* none : {"", "0k", "and", "in", "a-b", "a b", "\u03be"})
    EXPECT_FALSE(is_name_of_formula(none)) << none;
  EXPECT_TRUE(is_name_of_formula(std::string(64, 'a')));
  EXPECT_FALSE(is_name_of_formula(std::string(65, 'a')));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
