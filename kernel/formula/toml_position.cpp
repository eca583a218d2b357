#include "kernel/formula/toml_position.hpp"

#include <string>

namespace delcert {

namespace {

/// Goes through the text of a file, counting lines and characters.
class Walker {
 public:
  explicit Walker(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  [[nodiscard]] TextPosition position() const { return position_; }
  [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
  [[nodiscard]] bool next_is(std::string_view what) const { return text_.substr(at_).starts_with(what); }
  [[nodiscard]] char next(std::size_t further = 0) const {
    return at_ + further < text_.size() ? text_[at_ + further] : '\0';
  }
  [[nodiscard]] std::string_view ahead(std::size_t from, std::size_t length) const {
    return at_ + from < text_.size() ? text_.substr(at_ + from, length) : std::string_view();
  }

  void pass(std::size_t bytes) {
    for (; bytes > 0 && !at_end(); --bytes, ++at_) {
      if (text_[at_] == '\n') {
        ++position_.line;
        position_.column = 1;
      } else if (at_ + 1 >= text_.size() || (static_cast<unsigned char>(text_[at_ + 1]) & 0xC0U) != 0x80U) {
        ++position_.column;
      }
    }
  }
  void go_to(TextPosition where) {
    while (!at_end() && position_.line < where.line) pass(1);
    while (!at_end() && position_.line == where.line && position_.column < where.column) pass(1);
    // Not in the middle of a character.
    while (!at_end() && (static_cast<unsigned char>(text_[at_]) & 0xC0U) == 0x80U) ++at_;
  }
  [[nodiscard]] bool at_line_break() const { return next_is("\n") || next_is("\r\n"); }
  void pass_line_break() { pass(next_is("\r\n") ? 2 : 1); }
  void pass_white_space() {
    while (next_is(" ") || next_is("\t") || next_is("\n") || next_is("\r")) pass(1);
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  TextPosition position_;
};

std::size_t utf8_length(std::string_view hexadecimal) {
  std::size_t code = 0;
  for (const char c : hexadecimal) {
    const auto digit = static_cast<std::size_t>(c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
    code = 16 * code + digit;
  }
  if (code < 0x80) return 1;
  if (code < 0x800) return 2;
  return code < 0x10000 ? 3 : 4;
}

/// Passes a backslash between lines, which stands for nothing.
bool pass_joined_lines(Walker& walker) {
  if (walker.next() != '\\') return false;
  std::size_t blanks = 1;
  while (walker.next(blanks) == ' ' || walker.next(blanks) == '\t') ++blanks;
  if (walker.next(blanks) != '\n' && !(walker.next(blanks) == '\r' && walker.next(blanks + 1) == '\n')) return false;
  walker.pass(blanks);
  walker.pass_white_space();
  return true;
}

/// Passes what stands for one character of the value, or one byte of it; returns how many bytes of the value.
std::size_t pass_unit(Walker& walker, bool has_escapes) {
  if (has_escapes && walker.next() == '\\') {
    const char kind = walker.next(1);
    const std::size_t digits = kind == 'u' ? 4 : kind == 'U' ? 8 : 0;
    const std::size_t length = digits == 0 ? 1 : utf8_length(walker.ahead(2, digits));
    walker.pass(2 + digits);
    return length;
  }
  if (walker.at_line_break()) {
    walker.pass_line_break();
  } else {
    walker.pass(1);
  }
  return 1;
}

}  // namespace

TextPosition position_in_toml_string(std::string_view text, TextPosition begin, std::size_t offset) {
  Walker walker(text);
  walker.go_to(begin);
  const bool has_escapes = walker.next() == '"';
  const bool is_long = walker.next_is("\"\"\"") || walker.next_is("'''");
  walker.pass(is_long ? 3 : 1);
  if (is_long && walker.at_line_break()) walker.pass_line_break();
  const auto join = [&] {
    while (is_long && has_escapes && pass_joined_lines(walker)) {
    }
  };
  join();
  for (std::size_t passed = 0; passed < offset && !walker.at_end();) {
    passed += pass_unit(walker, has_escapes);
    join();
  }
  return walker.position();
}

}  // namespace delcert
