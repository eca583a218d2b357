#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kernel/manifold/builtin_manifolds.hpp"
#include "kernel/manifold/gluing/chart_gluing.hpp"
#include "kernel/manifold/gluing/metric_field.hpp"
#include "kernel/manifold/manifold_file.hpp"
#include "kernel/manifold/quotient/space_form.hpp"
#include "kernel/manifold/submanifold/zero_set.hpp"

namespace delcert {

/// A manifold as a file describes it, whatever its family.
using AnyManifold = std::variant<ManifoldDescription, SpaceFormDescription, MetricFieldDescription,
                                 FormulaAtlasDescription, SubmanifoldDescription>;

/// Reads a manifold in TOML; its key `family` says which reader is asked. `source` is the file's name for messages.
/// Throws InputError with file, line, column, key, what was found and what was expected; for a family that nobody knows
/// the one that was probably meant.
[[nodiscard]] AnyManifold parse_any_manifold(std::string_view text, const std::string& source);

/// The same, from a file. Throws InputError if it cannot be read.
[[nodiscard]] AnyManifold read_any_manifold(const std::filesystem::path& path);

/// What is built in, by the model that describes it.
struct BuiltinKind {
  std::string_view name;    ///< in the singular: "space form"
  std::string_view plural;  ///< "space forms"
  const std::vector<BuiltinManifold>* manifolds = nullptr;
};
[[nodiscard]] std::array<BuiltinKind, 5> builtin_kinds();

/// A built-in manifold by its name, otherwise the manifold of the file with this path. (A file that has the name of a
/// built-in manifold is reached as ./NAME.) Throws InputError, listing the names, if it is neither.
[[nodiscard]] AnyManifold find_any_manifold(const std::string& name_or_path);

/// The same for what takes flat tori and Euclidean balls only. Throws InputError for another family.
[[nodiscard]] ManifoldDescription find_manifold(const std::string& name_or_path);

}  // namespace delcert
