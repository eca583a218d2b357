#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace delcert::test {

/// A file of examples/complexes.
inline std::string complex_text(const std::string& name) {
  std::ifstream stream(DELCERT_SOURCE_DIR "/examples/complexes/" + name + ".toml");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (text.empty()) throw std::runtime_error("no example " + name);
  return text;
}

/// The text with the first occurrence of a part, which must be there, replaced.
inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) throw std::runtime_error("not in the text: " + part);
  return text.replace(at, part.size(), by);
}

}  // namespace delcert::test
