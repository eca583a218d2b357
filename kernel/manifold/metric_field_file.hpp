#pragma once

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

}  // namespace delcert
