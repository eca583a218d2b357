#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace delcert {

enum class TokenKind : unsigned char { number, word, symbol, end };

/// A piece of the text of a formula: a number (digits), a word (letters, digits, underscores), a symbol or its end.
struct Token {
  TokenKind kind = TokenKind::end;
  std::string text;
  std::size_t offset = 0;

  [[nodiscard]] bool is(std::string_view what) const { return kind != TokenKind::number && text == what; }
  /// For messages: the text in quotes, or "the end".
  [[nodiscard]] std::string shown() const { return kind == TokenKind::end ? "the end" : "'" + text + "'"; }
};

/// Words that are no names.
[[nodiscard]] bool is_keyword(std::string_view word);

/// Letters, digits and underscores, no digit first, at most 64 of them, and no keyword: what a formula can name.
[[nodiscard]] bool is_name_of_formula(std::string_view word);

/// Cuts a formula into tokens; the last one is the end. Throws FormulaError for a character that begins no token, for a
/// decimal number, whose value a reader would have to guess, and for words of more than 64 letters.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view text);

}  // namespace delcert
