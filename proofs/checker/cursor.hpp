#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace delcert::checker {

/// Walks through the text of a certificate. The format leaves no freedom of order or white space, so that reading is
/// expecting: every function throws Malformed with the position and what was expected there.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

  std::size_t position() const { return position_; }
  /// Whether the text goes on with the literal, which is then passed.
  bool accept(std::string_view literal);
  void expect(std::string_view literal);
  void expect_end();

  /// A JSON string, as it is written between the quotation marks: valid UTF-8, valid escapes, not decoded.
  std::string_view string();
  /// A string that is an exact number.
  std::string_view number();
  /// A JSON integer from 0 to largest.
  std::uint64_t count(std::uint64_t largest);
  std::int64_t integer();
  bool boolean();

  /// `[` item `,` item … `]`.
  template <class Item>
  void array(const Item& item) {
    expect("[");
    if (accept("]")) return;
    do {
      item();
    } while (accept(","));
    expect("]");
  }

  [[noreturn]] void fail(const std::string& rule, const std::string& expected) const;

 private:
  char next() const { return position_ < text_.size() ? text_[position_] : '\0'; }
  void escape();
  unsigned hexadecimal4();
  void beyond_ascii();

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace delcert::checker
