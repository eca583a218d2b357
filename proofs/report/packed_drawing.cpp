#include "proofs/report/packed_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "proofs/report/worst_simplices.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<std::uint32_t>;

/// Coordinate `axis` of all vertices; 0 beyond those that there are.
std::vector<double> axis_of(const Drawing& drawing, std::size_t axis) {
  std::vector<double> result(drawing.vertex_count());
  if (axis >= drawing.ambient_dimension) return result;
  for (std::size_t vertex = 0; vertex < result.size(); ++vertex)
    result[vertex] = drawing.coordinates[drawing.ambient_dimension * vertex + axis];
  return result;
}

/// Vertices along a curve that fills the drawing (Morton's): neighbours come soon after each other.
Numbers order_of_vertices(const Drawing& drawing) {
  constexpr unsigned bits = 16;
  std::vector<std::uint64_t> keys(drawing.vertex_count());
  for (std::size_t axis = 0; axis < drawing.ambient_dimension; ++axis) {
    std::vector<double> places = axis_of(drawing, axis);
    // Near infinity, as in a stereographic picture, all is one place.
    for (double& place : places) place = std::atan(place);
    const auto [low, high] = std::minmax_element(places.begin(), places.end());
    const double least = places.empty() ? 0 : *low, size = places.empty() || *high == *low ? 1 : *high - *low;
    for (std::size_t vertex = 0; vertex < keys.size(); ++vertex) {
      const auto cell = static_cast<std::uint64_t>((places[vertex] - least) / size * ((1U << bits) - 1));
      for (unsigned bit = 0; bit < bits; ++bit)
        keys[vertex] |= ((cell >> bit) & 1U) << (drawing.ambient_dimension * bit + axis);
    }
  }
  Numbers order(keys.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  return order;
}

template <class T>
std::vector<T> in_order(const std::vector<T>& values, const Numbers& order) {
  std::vector<T> result;
  result.reserve(order.size());
  for (const std::uint32_t at : order) result.push_back(values[at]);
  return result;
}

/// The simplices as increasing rows of new numbers of vertices, in lexicographic order, each with its old position.
std::vector<std::pair<Numbers, std::uint32_t>> sorted_simplices(const Drawing& drawing, const Numbers& new_numbers) {
  const std::size_t corners = drawing.dimension + 1;
  std::vector<std::pair<Numbers, std::uint32_t>> result;
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    Numbers row;
    for (std::size_t corner = 0; corner < corners; ++corner)
      row.push_back(new_numbers[drawing.simplices[corners * simplex + corner]]);
    std::sort(row.begin(), row.end());
    result.emplace_back(std::move(row), static_cast<std::uint32_t>(simplex));
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The worst values with the numbers of their simplices, the worst first.
Json worst_of(const std::vector<double>& values, bool least_is_worst) {
  Json result = Json::array();
  for (const std::uint32_t simplex : worst_simplices(values, least_is_worst))
    result.push_back(Json::array({simplex, values[simplex]}));
  return result;
}

Json json_of(const std::optional<double>& bound) { return bound ? Json(*bound) : Json(nullptr); }

/// What is no finite number is not measured.
std::vector<double> finite(std::vector<double> values) {
  for (double& value : values) {
    if (!std::isfinite(value)) value = std::numeric_limits<double>::quiet_NaN();
  }
  return values;
}

Json matching_faces(const Drawing& drawing, const Numbers& new_numbers, StreamBlock& block) {
  if (drawing.matching_faces.empty()) return nullptr;
  Numbers vertices, steps;
  std::map<std::string, std::uint32_t> numbers;
  Json texts = Json::array();
  for (const MatchingFaces& faces : drawing.matching_faces) {
    for (const Numbers* face : {&faces.first, &faces.second})
      for (const std::uint32_t vertex : *face) vertices.push_back(new_numbers[vertex]);
    const auto [place, is_new] = numbers.emplace(faces.step, static_cast<std::uint32_t>(texts.size()));
    if (is_new) texts.push_back(faces.step);
    steps.push_back(place->second);
  }
  return {{"vertices", block.add_varints(vertices)}, {"steps", block.add_varints(steps)}, {"texts", texts}};
}

}  // namespace

PackedDrawing packed_drawing(const Drawing& drawing, const std::vector<std::string>& exact,
                             const PackingDetail& detail) {
  const Numbers vertices = order_of_vertices(drawing);
  Numbers new_numbers(vertices.size());
  for (std::size_t at = 0; at < vertices.size(); ++at) new_numbers[vertices[at]] = static_cast<std::uint32_t>(at);
  std::vector<Numbers> rows;
  Numbers positions;
  for (auto& [row, simplex] : sorted_simplices(drawing, new_numbers)) {
    rows.push_back(row);
    positions.push_back(drawing.positions[simplex]);
  }

  StreamBlock block;
  Json json{{"dimension", drawing.dimension},
            {"geometry", drawing.geometry},
            {"model", name_of(drawing.model)},
            {"copies", name_of(drawing.copies)},
            {"ambient_dimension", drawing.ambient_dimension},
            {"projection", drawing.projection}};
  json["coordinates"] = Json::array();
  for (std::size_t axis = 0; axis < 3; ++axis)
    json["coordinates"].push_back(block.add_floats(in_order(axis_of(drawing, axis), vertices)));
  json["label"] = block.add_varints(in_order(drawing.labels, vertices));
  json["lift"] = block.add_varints(in_order(drawing.lifts, vertices));
  json["lifts"] = drawing.lift_texts;
  json["simplices"] = Json::array();
  for (const Numbers& column : columns_of_sorted_rows(rows)) json["simplices"].push_back(block.add_varints(column));

  for (const char* key : {"measures", "bounds", "worst"}) json[key] = Json::object();
  const auto add_measure = [&](const char* name, const std::vector<double>& all, const std::optional<double>& bound,
                               bool least_is_worst, bool is_wanted) {
    json["bounds"][name] = json_of(bound);
    json["measures"][name] = nullptr;
    if (all.empty() || !is_wanted) return;
    const std::vector<double> values = finite(in_order(all, positions));
    json["measures"][name] = block.add_codes(values, detail.measure_bytes);
    json["worst"][name] = worst_of(values, least_is_worst);
  };
  const SimplexMeasures& measures = drawing.measures;
  add_measure("protection", measures.protection, drawing.bounds.protection, true, true);
  add_measure("thickness", measures.thickness, drawing.bounds.thickness, true, true);
  add_measure("circumradius", measures.circumradius, drawing.bounds.circumradius, false, detail.has_all_measures);
  add_measure("hinge", measures.hinge, drawing.bounds.hinge, true, detail.has_all_measures);

  json["matching"] = matching_faces(drawing, new_numbers, block);
  json["domain"] = drawing.domain.empty() ? Json(nullptr) : block.add_floats(drawing.domain);
  json["exact"] = detail.has_exact_coordinates ? block.add_lines(exact) : Json(nullptr);
  return {std::move(json), block.base64()};
}

}  // namespace delcert
