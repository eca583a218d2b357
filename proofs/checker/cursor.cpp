#include "proofs/checker/cursor.hpp"

#include "proofs/checker/exact_number.hpp"
#include "proofs/checker/failure.hpp"

namespace delcert::checker {

void Cursor::fail(const std::string& rule, const std::string& expected) const {
  throw Malformed(rule, "byte " + std::to_string(position_) + ": expected " + expected);
}

bool Cursor::accept(std::string_view literal) {
  if (!text_.substr(position_).starts_with(literal)) return false;
  position_ += literal.size();
  return true;
}

void Cursor::expect(std::string_view literal) {
  if (!accept(literal)) fail("form.keys", std::string(literal));
}

void Cursor::expect_end() {
  if (!accept("\n")) fail("form.bytes", "a line feed");
  if (position_ != text_.size()) fail("form.bytes", "the end of the document");
}

std::string_view Cursor::string() {
  if (!accept("\"")) fail("form.types", "a string");
  const std::size_t begin = position_;
  while (!accept("\"")) {
    const auto byte = static_cast<unsigned char>(next());
    if (byte < 0x20) fail("form.bytes", "a string without control characters");
    if (byte >= 0x80) {
      beyond_ascii();
    } else if (byte == '\\') {
      escape();
    } else {
      ++position_;
    }
  }
  return text_.substr(begin, position_ - begin - 1);
}

void Cursor::escape() {
  ++position_;
  if (std::string_view("\"\\/bfnrt").find(next()) != std::string_view::npos) {
    ++position_;
    return;
  }
  if (!accept("u")) fail("form.bytes", "an escape sequence of JSON");
  const unsigned unit = hexadecimal4();
  if (unit < 0xd800 || unit > 0xdfff) return;
  if (unit > 0xdbff || !accept("\\u")) fail("form.bytes", "a surrogate pair");
  const unsigned low = hexadecimal4();
  if (low < 0xdc00 || low > 0xdfff) fail("form.bytes", "a surrogate pair");
}

unsigned Cursor::hexadecimal4() {
  unsigned value = 0;
  for (int i = 0; i < 4; ++i) {
    const std::size_t digit = std::string_view("0123456789abcdefABCDEF").find(next());
    if (digit == std::string_view::npos) fail("form.bytes", "four hexadecimal digits");
    value = 16 * value + static_cast<unsigned>(digit < 16 ? digit : digit - 6);
    ++position_;
  }
  return value;
}

void Cursor::beyond_ascii() {
  const auto lead = static_cast<unsigned char>(next());
  const int more = lead < 0xc2 || lead > 0xf4 ? -1 : lead < 0xe0 ? 1 : lead < 0xf0 ? 2 : 3;
  // The second byte excludes overlong forms, surrogates and code points above U+10FFFF.
  unsigned lowest = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
  unsigned highest = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
  if (more < 0) fail("form.bytes", "valid UTF-8");
  ++position_;
  for (int i = 0; i < more; ++i, lowest = 0x80, highest = 0xbf, ++position_) {
    const auto byte = static_cast<unsigned char>(next());
    if (byte < lowest || byte > highest) fail("form.bytes", "valid UTF-8");
  }
}

std::string_view Cursor::number() {
  const std::size_t begin = position_;
  const std::string_view text = string();
  if (is_exact_number(text)) return text;
  position_ = begin;
  fail("form.numbers", "an exact number in quotation marks (integer, fraction or hexadecimal float)");
}

std::uint64_t Cursor::count(std::uint64_t largest) {
  const std::size_t begin = position_;
  std::uint64_t value = 0;
  const auto at_digit = [this] { return next() >= '0' && next() <= '9'; };
  bool fits = at_digit();
  for (const bool leading_zero = next() == '0'; fits && at_digit(); ++position_) {
    if (leading_zero && position_ > begin) fail("form.types", "an integer without leading zeros");
    const auto digit = static_cast<std::uint64_t>(next() - '0');
    fits = digit <= largest && value <= (largest - digit) / 10;
    value = 10 * value + digit;
  }
  if (fits) return value;
  position_ = begin;
  fail("form.types", "an integer from 0 to " + std::to_string(largest));
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
