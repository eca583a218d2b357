#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/manifold/builtin_manifolds.hpp"
#include "kernel/manifold/gluing/chart_gluing.hpp"

namespace delcert {

/// The files of examples/manifolds/atlases, ordered by name. The definition is generated (cmake/EmbedFiles.cmake).
[[nodiscard]] const std::vector<BuiltinManifold>& builtin_atlases();

/// Reads charts and transitions in TOML (docs/atlases.md); `source` is the file's name for messages. Whether they are
/// an atlas is not looked at. Throws InputError with file, line, column, key, what was found and what was expected.
[[nodiscard]] FormulaAtlasDescription parse_atlas(std::string_view text, const std::string& source);

}  // namespace delcert
