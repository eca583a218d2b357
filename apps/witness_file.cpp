#include "apps/witness_file.hpp"

#include <fstream>
#include <string_view>

namespace delcert {

WitnessFile witness_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string start(64, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  std::erase_if(start, [](char letter) { return std::string_view(" \t\r\n").find(letter) != std::string_view::npos; });
  if (start.starts_with("{\"delcert_witness\"")) return WitnessFile::witness;
  return start.starts_with("{\"seed\"") ? WitnessFile::attack : WitnessFile::other;
}

}  // namespace delcert
