#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/manifold/builtin_manifolds.hpp"
#include "kernel/manifold/submanifold/zero_set.hpp"

namespace delcert {

/// The files of examples/manifolds/submanifolds, ordered by name. The definition is generated (cmake/EmbedFiles.cmake).
[[nodiscard]] const std::vector<BuiltinManifold>& builtin_submanifolds();

/// Reads a zero set or a mesh in TOML (docs/submanifolds.md); `source` is the file's name for messages, and the file of
/// a mesh is looked for from its folder. Whether it is a manifold is not looked at. Throws InputError with file, line,
/// column, key, what was found and what was expected; in a formula the column is that of what is wrong in it.
[[nodiscard]] SubmanifoldDescription parse_submanifold(std::string_view text, const std::string& source);

/// The zero set, or the polyhedron. Throws what their constructors throw. Precondition: rounding to nearest.
[[nodiscard]] std::shared_ptr<const EmbeddedManifold> embedded_manifold(const SubmanifoldDescription& description);

}  // namespace delcert
