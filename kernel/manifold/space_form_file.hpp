#pragma once

#include <filesystem>
#include <optional>
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

/// The same, from a file. Throws InputError if it cannot be read.
[[nodiscard]] SpaceFormDescription read_space_form(const std::filesystem::path& path);

/// The built-in space form of this name. Throws InputError, listing the names, if there is none.
[[nodiscard]] SpaceFormDescription find_space_form(const std::string& name);

/// The built-in space form of this name, or that of the file with this path. None if there is neither, or the file is
/// none or of a family of manifolds of which `find_manifold` knows. Throws InputError as `read_space_form`.
[[nodiscard]] std::optional<SpaceFormDescription> space_form_if_one(const std::string& name_or_path);

}  // namespace delcert
