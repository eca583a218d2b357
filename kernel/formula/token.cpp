#include "kernel/formula/token.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "kernel/formula/formula_error.hpp"

namespace delcert {

namespace {

constexpr std::size_t longest_word = 64;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

std::size_t symbol_length(std::string_view rest) {
  static constexpr std::array<std::string_view, 3> longer{"<=", ">=", ".."};
  for (const std::string_view symbol : longer) {
    if (rest.substr(0, 2) == symbol) return 2;
  }
  return std::string_view("+-*/^()[]<>=,:").find(rest[0]) == std::string_view::npos ? 0 : 1;
}

template <class Belongs>
std::size_t end_of(std::string_view text, std::size_t from, const Belongs& belongs) {
  while (from < text.size() && belongs(text[from])) ++from;
  return from;
}

/// What other languages write, and how it is written here. Longer ones first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 21> foreign{{
    {"==", "write ="},
    {"!=", "write not (a = b)"},
    {"<>", "write not (a = b)"},
    {"**", "write ^"},
    {"=>", "write implies"},
    {"->", "write implies"},
    {"&", "write and"},
    {"|", "write or, or abs(x)"},
    {"!", "write not"},
    {".", "decimal numbers are not exact, write a fraction"},
    {"{", "write ("},
    {"\u2264", "write <="},
    {"\u2265", "write >="},
    {"\u2260", "write not (a = b)"},
    {"\u2212", "write -"},
    {"\u00b7", "write *"},
    {"\u00d7", "write *"},
    {"\u221a", "write sqrt(x)"},
    {"\u00b2", "write ^2"},
    {"\u2200", "write forall"},
    {"\u2203", "write exists"},
}};

const std::pair<std::string_view, std::string_view>* foreign_at(std::string_view rest) {
  const auto* const found =
      std::find_if(foreign.begin(), foreign.end(), [&](const auto& entry) { return rest.starts_with(entry.first); });
  return found == foreign.end() ? nullptr : found;
}

/// The character at the beginning, all its bytes, in quotes; by its number if it cannot be shown.
std::string shown_character(std::string_view rest) {
  const auto first = static_cast<unsigned char>(rest[0]);
  if (first < 0x20 || first == 0x7f) {
    std::array<char, 16> text{};
    (void)std::snprintf(text.data(), text.size(), "U+%04X", static_cast<unsigned>(first));
    return text.data();
  }
  std::size_t length = 1;
  while (length < rest.size() && length < 4 && (static_cast<unsigned char>(rest[length]) & 0xC0U) == 0x80U) ++length;
  return "'" + std::string(rest.substr(0, first < 0x80 ? 1 : length)) + "'";
}

[[noreturn]] void refuse(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  if (const auto* const entry = foreign_at(rest)) {
    throw FormulaError(at, "'" + std::string(entry->first) + "' means nothing here: " + std::string(entry->second));
  }
  throw FormulaError(at, "the character " + shown_character(rest) + " begins nothing");
}

}  // namespace

bool is_keyword(std::string_view word) {
  constexpr std::array<std::string_view, 7> keywords{"and", "or", "not", "implies", "forall", "exists", "in"};
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

bool is_name_of_formula(std::string_view word) {
  return !word.empty() && word.size() <= longest_word && is_letter(word[0]) && !is_keyword(word) &&
         std::all_of(word.begin(), word.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

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
      if (end - at > longest_word) throw FormulaError(at, "a word of more than 64 letters");
    } else {
      end = at + symbol_length(text.substr(at));
      const auto* const entry = foreign_at(text.substr(at));
      if (end == at || (entry != nullptr && entry->first.size() > end - at)) refuse(text, at);
    }
    tokens.push_back({kind, std::string(text.substr(at, end - at)), at});
    at = end;
  }
  tokens.push_back({TokenKind::end, "", text.size()});
  return tokens;
}

}  // namespace delcert
