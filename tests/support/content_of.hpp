#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace delcert::test {

/// All bytes of a file; nothing for one that cannot be read.
inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace delcert::test
