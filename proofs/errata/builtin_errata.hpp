#pragma once

#include <string>
#include <vector>

namespace delcert {

/// A file of proofs/errata, as it is in the library.
struct BuiltinErratum {
  std::string name;  ///< the file's name without the ending
  std::string text;
};

/// All of them, ordered by name. The definition is generated (cmake/EmbedFiles.cmake).
[[nodiscard]] const std::vector<BuiltinErratum>& builtin_errata();

}  // namespace delcert
