#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "kernel/manifold/builtin_manifolds.hpp"
#include "kernel/manifold/gluing/metric_field.hpp"

namespace delcert {

/// The files of examples/manifolds/metric-fields, ordered by name. The definition is generated
/// (cmake/EmbedFiles.cmake).
[[nodiscard]] const std::vector<BuiltinManifold>& builtin_metric_fields();

/// Reads a metric field in TOML (docs/metric-fields.md); `source` is the file's name for messages. Whether the metric
/// is positive definite is not looked at. Throws InputError with file, line, column, key, what was found and what was
/// expected.
[[nodiscard]] MetricFieldDescription parse_metric_field(std::string_view text, const std::string& source);

/// The built-in metric field of this name, or that of the file with this path. None if there is neither, or the file is
/// none or of another family. Throws InputError as `parse_metric_field`.
[[nodiscard]] std::optional<MetricFieldDescription> metric_field_if_one(const std::string& name_or_path);

}  // namespace delcert
