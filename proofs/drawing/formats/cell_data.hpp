#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/drawing/drawing.hpp"

namespace delcert {

/// The measures of a drawing that are there, by their names, a number for each simplex in the order of the drawing.
struct NamedMeasure {
  std::string_view name;
  std::vector<double> values;
};
[[nodiscard]] std::vector<NamedMeasure> named_measures(const Drawing& drawing);

/// Three coordinates, the last 0 where there are two.
[[nodiscard]] std::array<double, 3> space_point(const Drawing& drawing, std::size_t vertex);

/// A line for each lift: "lift 3: 0 1 0". None where there is only one.
[[nodiscard]] std::vector<std::string> lift_lines(const Drawing& drawing);

/// A comment for each line of these, the mark before it.
[[nodiscard]] std::string comment_lines(std::string_view mark, const std::string& origin,
                                        const std::vector<std::string>& lines);

}  // namespace delcert
