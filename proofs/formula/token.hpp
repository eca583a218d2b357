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

/// Cuts a formula into tokens; the last one is the end. Throws FormulaError for a character that begins no token, and
/// for a decimal number, whose value a reader would have to guess.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view text);

}  // namespace delcert
