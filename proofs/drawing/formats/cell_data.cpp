#include "proofs/drawing/formats/cell_data.hpp"

#include <fmt/format.h>

namespace delcert {

std::vector<NamedMeasure> named_measures(const Drawing& drawing) {
  std::vector<NamedMeasure> result;
  const auto add = [&result, &drawing](std::string_view name, const std::vector<double>& by_position) {
    if (by_position.empty()) return;
    NamedMeasure measure{name, {}};
    for (const std::uint32_t position : drawing.positions) measure.values.push_back(by_position[position]);
    result.push_back(std::move(measure));
  };
  add("protection", drawing.measures.protection);
  add("thickness", drawing.measures.thickness);
  add("circumradius", drawing.measures.circumradius);
  add("hinge", drawing.measures.hinge);
  return result;
}

std::array<double, 3> space_point(const Drawing& drawing, std::size_t vertex) {
  std::array<double, 3> result{};
  for (std::size_t axis = 0; axis < drawing.ambient_dimension; ++axis)
    result[axis] = drawing.coordinates[vertex * drawing.ambient_dimension + axis];
  return result;
}

std::vector<std::string> lift_lines(const Drawing& drawing) {
  std::vector<std::string> result;
  if (drawing.lift_texts.size() < 2) return result;
  for (std::size_t lift = 0; lift < drawing.lift_texts.size(); ++lift)
    result.push_back(fmt::format("lift {}: {}", lift, drawing.lift_texts[lift]));
  return result;
}

std::string comment_lines(std::string_view mark, const std::string& origin, const std::vector<std::string>& lines) {
  std::string result = fmt::format("{}{}\n", mark, origin);
  for (const std::string& line : lines) result += fmt::format("{}{}\n", mark, line);
  return result;
}

}  // namespace delcert
