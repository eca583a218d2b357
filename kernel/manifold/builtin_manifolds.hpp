#pragma once

#include <string>
#include <vector>

namespace delcert {

/// A file of examples/manifolds, as it is in the library.
struct BuiltinManifold {
  /// The file's name without the ending.
  std::string name;
  /// Its content.
  std::string text;
};

/// All of them, ordered by name. The definition is generated (cmake/EmbedFiles.cmake).
[[nodiscard]] const std::vector<BuiltinManifold>& builtin_manifolds();

}  // namespace delcert
