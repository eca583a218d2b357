#pragma once

#include <string>

#include "proofs/checker/certificate/input.hpp"

namespace delcert::fuzz {

/// Calls `read` with the bytes as they are, and where they end in a seal also with one that fits, so that the content
/// counts and not the seal alone.
template <typename Read>
void read_with_both_seals(const std::string& bytes, const Read& read) {
  read(bytes);
  const std::string key = ",\"sha256\":\"";
  const std::size_t seal = bytes.rfind(key);
  if (seal == std::string::npos) return;
  const std::string content = bytes.substr(0, seal);
  read(content + key + checker::sha256(content) + "\"}\n");
}

}  // namespace delcert::fuzz
