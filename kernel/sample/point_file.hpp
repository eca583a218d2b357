#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/number/rational.hpp"
#include "kernel/number/strong.hpp"

namespace delcert {

/// Points in coordinates, as files hold them.
using PointList = std::vector<std::vector<Rational>>;

/// Reads points: one a line, m exact numbers separated by spaces or tabs; what follows "#" is a comment, and lines
/// without numbers are skipped. Lines end with a line feed, with or without a carriage return before it. Equal points
/// are not an error here. `source` is the file's name for messages.
/// Throws InputError with file, line, column, what was found and what was expected; also if there is no point.
[[nodiscard]] PointList parse_points(std::string_view text, Dimension dimension, const std::string& source);

/// The same, from a file. Throws InputError if it cannot be read.
[[nodiscard]] PointList read_points(const std::filesystem::path& path, Dimension dimension);

/// The text that parse_points reads back to the same points.
[[nodiscard]] std::string points_text(const PointList& points);

}  // namespace delcert
