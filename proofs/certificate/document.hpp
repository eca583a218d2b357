#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "kernel/number/rational.hpp"
#include "kernel/parallel/parts.hpp"
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
  /// ,"key":[text(0),text(1),...]. In parallel: `text` is called in any thread.
  template <class Text>
  void add_array(std::string_view key, std::size_t count, const Text& text) {
    add(",\"");
    add(key);
    add("\":[");
    const auto some = [&text](std::size_t first, std::size_t last) {
      std::string part;
      for (std::size_t at = first; at < last; ++at) {
        if (at > 0) part += ',';
        part += text(at);
      }
      return part;
    };
    const auto report_more = [this, before = written_](std::string_view, std::size_t done, std::size_t) {
      written_ = before + done;
      report();
    };
    in_parts<64>("write", count, report_more, some, [this](const std::string& part) { add(part); });
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
