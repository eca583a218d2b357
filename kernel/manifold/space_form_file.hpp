#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/manifold/builtin_manifolds.hpp"
#include "kernel/manifold/quotient/space_form.hpp"

namespace delcert {

/// The files of examples/manifolds/space-forms, ordered by name. The definition is generated (cmake/EmbedFiles.cmake).
[[nodiscard]] const std::vector<BuiltinManifold>& builtin_space_forms();

/// Reads the description of a space form in TOML (docs/space-forms.md); `source` is the file's name for messages. The
/// group is not verified. Throws InputError with file, line, column, key, what was found and what was expected.
[[nodiscard]] SpaceFormDescription parse_space_form(std::string_view text, const std::string& source);

/// The built-in space form of this name. Throws InputError, listing the names, if there is none.
[[nodiscard]] SpaceFormDescription find_space_form(const std::string& name);

}  // namespace delcert
