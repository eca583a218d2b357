#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace delcert::checker {

/// Walks through the text of a certificate. The format leaves no freedom of order or white space, so that reading is
/// expecting: every function throws Malformed with the position and what was expected there.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

  std::string_view passed() const { return text_.substr(0, position_); }
  /// Another one where the literal comes next, or at the end if it does not come.
  Cursor before_next(std::string_view literal) const {
    Cursor other = *this;
    other.position_ = std::min(text_.find(literal, position_), text_.size());
    return other;
  }
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

  /// `[` item `,` item … `]`, of any length.
  template <class Item>
  void array(const Item& item) {
    expect("[");
    if (accept("]")) return;
    do {
      item();
    } while (accept(","));
    expect("]");
  }
  /// The same with exactly `length` > 0 items.
  template <class Item>
  void row(int length, const Item& item) {
    for (int k = 0; k < length; ++k) {
      expect(k == 0 ? "[" : ",");
      item();
    }
    expect("]");
  }

  [[noreturn]] void fail(std::string_view rule, std::string_view expected) const;

 private:
  std::string_view quoted();

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace delcert::checker
