#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

/// What libFuzzer calls, and corpus_driver.cpp for the files of a corpus: one input of a reader. Nothing but the errors
/// that the reader documents may come out of it; anything else ends the program.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace delcert::fuzz {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return size == 0 ? std::string() : std::string(reinterpret_cast<const char*>(data), size);
}

/// Ends the program unless the property holds.
inline void require(bool holds, const char* property) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", property);
  std::abort();
}

/// The message of an error that a user sees: on one line, and beginning with the name of the file.
inline void require_message(const std::string& message, const std::string& file) {
  require(message.starts_with(file), "an error names the file");
  require(message.find('\n') == std::string::npos, "an error is one line");
}

}  // namespace delcert::fuzz
