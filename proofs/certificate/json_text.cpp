#include "proofs/certificate/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::string_view delimiters = ",:]} \n\r\t";

}  // namespace

std::string_view JsonText::string() {
  pass_space();
  const std::size_t start = at_ + 1;
  pass_string();
  return text_.substr(start, at_ - 1 - start);
}

std::string_view JsonText::skip() {
  pass_space();
  const std::size_t start = at_;
  std::size_t depth = 0;
  do {
    if (at_ == text_.size()) fail("a value");
    const char c = text_[at_];
    if (c == '"') {
      pass_string();
    } else if (c == '[' || c == '{') {
      ++depth;
      ++at_;
    } else if (depth > 0) {
      if (c == ']' || c == '}') --depth;
      ++at_;
    } else {
      at_ = std::min(text_.find_first_of(delimiters, at_), text_.size());
    }
  } while (depth > 0);
  if (at_ == start) fail("a value");
  return text_.substr(start, at_ - start);
}

void JsonText::expect_end() {
  pass_space();
  if (at_ < text_.size()) fail("the end");
}

void JsonText::pass_string() {
  if (at_ == text_.size() || text_[at_] != '"') fail("a string");
  for (++at_; at_ < text_.size(); ++at_) {
    if (text_[at_] == '\\')
      ++at_;
    else if (text_[at_] == '"') {
      ++at_;
      return;
    }
  }
  at_ = text_.size();
  fail("the end of a string");
}

void JsonText::fail(const std::string& expected) const {
  throw InputError(fmt::format("JSON: expected {} after {} bytes, found {}", expected, at_,
                               at_ < text_.size() ? "another character" : "the end of the file"));
}

}  // namespace delcert
