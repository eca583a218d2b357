#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

namespace delcert {

/// Reads a JSON text from its beginning to its end, and builds no tree of values: a certificate is nearly all numbers,
/// for which a tree takes most of the time and room. What is read is checked; what is passed over only has to have
/// brackets and strings that end. All functions throw InputError, with the place, for a text that is otherwise.
class JsonText {
 public:
  /// Keeps a reference to the text.
  explicit JsonText(std::string_view text) : text_(text) {}

  /// Of an object: calls `read` with each key, as it is written; `read` has to read or skip the value.
  template <class Read>
  void object(const Read& read) {
    all_between('{', '}', "an object", [&] {
      const std::string_view key = string();
      expect(':', "a colon");
      read(key);
    });
  }

  /// Of a list: calls `read` at each element, which it has to read or skip.
  template <class Read>
  void list(const Read& read) {
    all_between('[', ']', "a list", read);
  }

  /// What is between the quotation marks, as it is written.
  [[nodiscard]] std::string_view string();

  template <std::integral T>
  [[nodiscard]] T integer() {
    pass_space();
    T result{};
    const auto [end, failure] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), result);
    if (failure != std::errc()) fail("an integer in its range");
    at_ = static_cast<std::size_t>(end - text_.data());
    // 1.5, 1e3.
    if (at_ < text_.size() && (text_[at_] == '.' || text_[at_] == 'e' || text_[at_] == 'E')) fail("an integer");
    return result;
  }

  /// The text of a value of any kind.
  std::string_view skip();

  /// Only white space is left.
  void expect_end();

 private:
  template <class Read>
  void all_between(char open, char close, const char* what, const Read& read) {
    expect(open, what);
    if (accept(close)) return;
    do {
      read();
    } while (accept(','));
    expect(close, "a comma, or the end of the list or object");
  }

  void pass_space() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }
  [[nodiscard]] bool accept(char c) {
    pass_space();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c, const char* what) {
    if (!accept(c)) fail(what);
  }
  void pass_string();
  [[nodiscard]] static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
  [[noreturn]] void fail(const std::string& expected) const;

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace delcert
