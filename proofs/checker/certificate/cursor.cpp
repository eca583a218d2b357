#include "proofs/checker/certificate/cursor.hpp"

#include <charconv>
#include <nlohmann/json.hpp>

#include "proofs/checker/arithmetic/exact_number.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

void Cursor::fail(std::string_view rule, std::string_view expected) const {
  throw Malformed(rule, "byte " + std::to_string(position_) + ": expected " + std::string(expected));
}

bool Cursor::accept(std::string_view literal) {
  // Most literals are brackets and commas.
  if (position_ >= text_.size() || text_[position_] != literal[0]) return false;
  if (literal.size() > 1 && !text_.substr(position_).starts_with(literal)) return false;
  position_ += literal.size();
  return true;
}

void Cursor::expect(std::string_view literal) {
  if (!accept(literal)) fail("form.keys", literal);
}

void Cursor::expect_end() {
  if (!accept("\n")) fail("form.bytes", "a line feed");
  if (position_ != text_.size()) fail("form.bytes", "the end of the document");
}

/// What stands between quotation marks, a backslash and the character after it taken together.
std::string_view Cursor::quoted() {
  if (!accept("\"")) fail("form.types", "a string");
  const std::size_t begin = position_;
  for (; position_ < text_.size() && text_[position_] != '"'; ++position_) {
    if (text_[position_] == '\\') ++position_;
  }
  if (position_ >= text_.size()) fail("form.bytes", "the end of the string");
  return text_.substr(begin, position_++ - begin);
}

std::string_view Cursor::string() {
  const std::string_view content = quoted();
  const std::string_view with_marks = text_.substr(position_ - content.size() - 2, content.size() + 2);
  if (!nlohmann::json::accept(with_marks.begin(), with_marks.end()))
    fail("form.bytes", "a JSON string in UTF-8 before this");
  return content;
}

std::string_view Cursor::number() {
  // What is as it should be is read once.
  if (accept("\"")) {
    const std::string_view content = text_.substr(position_, exact_number_length(text_.substr(position_)));
    const std::size_t end = position_ + content.size();
    if (!content.empty() && end < text_.size() && text_[end] == '"') {
      position_ = end + 1;
      return content;
    }
    --position_;
  }
  const std::string_view content = quoted();
  if (!is_exact_number(content))
    fail("form.numbers", "an exact number (integer, fraction, hexadecimal float) before this");
  return content;
}

std::uint64_t Cursor::count(std::uint64_t largest) {
  std::uint64_t value = 0;
  const char* begin = text_.data() + position_;
  const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
  const bool leading_zero = end - begin > 1 && *begin == '0';
  if (error != std::errc{} || leading_zero || value > largest)
    fail("form.types", "an integer from 0 to " + std::to_string(largest));
  position_ += static_cast<std::size_t>(end - begin);
  return value;
}

std::int64_t Cursor::integer() {
  const bool negative = accept("-");
  const auto magnitude = static_cast<std::int64_t>(count(INT64_MAX));
  if (negative && magnitude == 0) fail("form.types", "an integer other than -0");
  return negative ? -magnitude : magnitude;
}

bool Cursor::boolean() {
  if (accept("true")) return true;
  if (!accept("false")) fail("form.types", "true or false");
  return false;
}

}  // namespace delcert::checker
