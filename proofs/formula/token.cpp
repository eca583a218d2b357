#include "proofs/formula/token.hpp"

#include <array>

#include "proofs/formula/formula_error.hpp"

namespace delcert {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

std::size_t symbol_length(std::string_view rest) {
  static constexpr std::array<std::string_view, 3> longer{"<=", ">=", ".."};
  for (const std::string_view symbol : longer) {
    if (rest.substr(0, 2) == symbol) return 2;
  }
  return std::string_view("+-*/^()<>=,:").find(rest[0]) == std::string_view::npos ? 0 : 1;
}

template <class Belongs>
std::size_t end_of(std::string_view text, std::size_t from, const Belongs& belongs) {
  while (from < text.size() && belongs(text[from])) ++from;
  return from;
}

[[noreturn]] void refuse(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  const auto begins_with = [&](std::string_view word) { return rest.substr(0, word.size()) == word; };
  std::string hint;
  if (begins_with("\u2264")) hint = ": write <=";
  if (begins_with("\u2265")) hint = ": write >=";
  if (begins_with("!") || begins_with("\u2260")) hint = ": write not (a = b)";
  if (begins_with("&")) hint = ": write and";
  if (begins_with("|")) hint = ": write or, or abs(x)";
  if (begins_with(".")) hint = ": decimal numbers are not exact, write a fraction";
  throw FormulaError(at, "a character that begins nothing" + hint);
}

}  // namespace

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t at = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      ++at;
      continue;
    }
    std::size_t end = at;
    TokenKind kind = TokenKind::symbol;
    if (is_digit(c)) {
      kind = TokenKind::number;
      end = end_of(text, at, is_digit);
      const bool is_range = text.substr(end, 2) == "..";
      if (end < text.size() && text[end] == '.' && !is_range) {
        throw FormulaError(end, "a decimal number: decimal numbers are not exact, write a fraction such as 1/4");
      }
      if (end < text.size() && is_letter(text[end])) {
        throw FormulaError(end, "a letter after a number: products are written with *");
      }
    } else if (is_letter(c)) {
      kind = TokenKind::word;
      end = end_of(text, at, [](char d) { return is_letter(d) || is_digit(d); });
    } else {
      end = at + symbol_length(text.substr(at));
      if (end == at) refuse(text, at);
    }
    tokens.push_back({kind, std::string(text.substr(at, end - at)), at});
    at = end;
  }
  tokens.push_back({TokenKind::end, "", text.size()});
  return tokens;
}

}  // namespace delcert
