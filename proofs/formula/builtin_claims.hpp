#pragma once

#include <string>
#include <vector>

namespace delcert {

/// A file of proofs/claims, as it is in the library.
struct BuiltinClaim {
  std::string name;  ///< the file's name without the ending
  std::string text;
};

/// All of them, ordered by name. The definition is generated (cmake/EmbedFiles.cmake).
[[nodiscard]] const std::vector<BuiltinClaim>& builtin_claims();

}  // namespace delcert
