#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "kernel/number/rational.hpp"
#include "proofs/certificate/byte_sink.hpp"
#include "support/progress.hpp"

namespace delcert {

/// JSON of docs/certificate-format.md: a string, an exact number.
[[nodiscard]] std::string quoted(const std::string& text);
[[nodiscard]] std::string number(const Rational& x);

/// Elements separated by commas between brackets.
template <class Range, class Text>
[[nodiscard]] std::string listed(const Range& range, const Text& text) {
  std::string result = "[";
  for (const auto& element : range) {
    if (result.size() > 1) result += ',';
    result += text(element);
  }
  return result + "]";
}

/// A certificate that is being written, compressed if the name ends in ".zst": long arrays are not held. The file
/// appears whole or not at all, when it is sealed.
class Document {
 public:
  /// `elements`: how many there are in all arrays, for the progress.
  Document(const std::filesystem::path& path, std::size_t elements, const Progress& progress)
      : sink_(path), elements_(elements), progress_(progress) {}

  void add(std::string_view text);
  /// ,"key":[text(0),text(1),...]
  template <class Text>
  void add_array(std::string_view key, std::size_t count, const Text& text) {
    add(",\"");
    add(key);
    add("\":[");
    for (std::size_t at = 0; at < count; ++at) {
      if (at > 0) add(",");
      add(text(at));
      if (++written_ % 256 == 0) report();
    }
    add("]");
  }
  /// Adds the digest of all before it and the end. Nothing may follow.
  void seal();

 private:
  void report() const { progress_("write the certificate", written_, elements_); }
  void flush();

  ByteSink sink_;
  std::string buffer_;
  std::size_t written_ = 0;
  std::size_t elements_;
  const Progress& progress_;
};

}  // namespace delcert
