#include "properties/instances/configuration_map.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "kernel/number/exact_text.hpp"
#include "kernel/simplex/matrix_norm.hpp"
#include "properties/instances/configuration_geometry.hpp"
#include "properties/instances/exact_point.hpp"
#include "properties/instances/map_object.hpp"
#include "properties/instances/pair_distortion.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

SymmetricMatrix<Rational> matrix_of(const std::vector<std::vector<Rational>>& rows) {
  SymmetricMatrix<Rational> result(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows[row].size() != row + 1) throw InputError("a configuration map: stretching is not a lower triangle");
    for (std::size_t column = 0; column <= row; ++column) result(row, column) = rows[row][column];
  }
  return result;
}

/// The number of a point among some; their count if it is not there.
std::size_t number_of(const SimplexObject::Points& points, const std::vector<Rational>& point) {
  return static_cast<std::size_t>(std::find(points.begin(), points.end(), point) - points.begin());
}

SimplexObject::Points listed_points(const Json& json, const std::string& key) {
  if (!json.is_array()) throw InputError("a configuration map: " + key + " is not a list");
  SimplexObject::Points result;
  for (const Json& point : json) result.push_back(rationals_from(point, key));
  return result;
}

}  // namespace

ConfigurationMap::ConfigurationMap(Finite finite) : finite_(std::move(finite)) {
  const auto& [points, images, distortion] = *finite_;
  if (points.empty() || points.size() != images.size()) {
    throw InputError("a configuration map: as many images as points, and not none");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].empty() || points[i].size() != points[0].size() || images[i].size() != points[0].size()) {
      throw InputError("a configuration map: its parts are not of one dimension");
    }
  }
  if (distortion < Rational(0) || Rational(1) <= distortion) {
    throw InputError("a configuration map: its distortion is not below 1");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational squared = squared_distance_between(points[i], points[j]);
      if (!lengths_differ_by_at_most(squared, squared_distance_between(images[i], images[j]),
                                     square(distortion) * squared)) {
        throw InputError("a configuration map: a distance is distorted more than certified");
      }
    }
  }
}

ConfigurationMap::ConfigurationMap(Data data) : data_(std::move(data)) {
  const std::size_t m = data_.mirror.size();
  if (m == 0 || data_.stretching.size() != m || data_.fold_direction.size() != m || data_.fold_normal.size() != m) {
    throw InputError("a configuration map: its parts are not of one dimension");
  }
  const SymmetricMatrix<Rational> stretching = matrix_of(data_.stretching);
  if (data_.stretch < Rational(0) || !is_proved(is_symmetric_norm_at_most(stretching, data_.stretch))) {
    throw InputError("a configuration map: stretching has a norm above stretch");
  }
  const Rational squared =
      pairing(data_.fold_direction, data_.fold_direction) * pairing(data_.fold_normal, data_.fold_normal);
  if (data_.fold < Rational(0) || square(data_.fold) < squared) {
    throw InputError("a configuration map: its fold has a Lipschitz constant above fold");
  }
  if (Rational(1) <= distortion()) throw InputError("a configuration map: its distortion is not below 1");
}

bool ConfigurationMap::is_defined_on(const SimplexObject::Points& points) const {
  return std::all_of(points.begin(), points.end(), [this](const auto& point) {
    return point.size() == dimension() && (!finite_ || number_of(finite_->points, point) < finite_->points.size());
  });
}

SimplexObject::Points ConfigurationMap::image(const SimplexObject::Points& points) const {
  if (finite_) {
    if (!is_defined_on(points)) throw InputError("a configuration map: it is not defined on a point");
    SimplexObject::Points result;
    for (const auto& point : points) result.push_back(finite_->images[number_of(finite_->points, point)]);
    return result;
  }
  const SymmetricMatrix<Rational> stretching = matrix_of(data_.stretching);
  SimplexObject::Points result = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].size() != dimension()) throw InputError("a configuration map: a point of another dimension");
    const Rational folded = absolute(pairing(data_.fold_normal, points[i]) - data_.fold_offset);
    for (std::size_t row = 0; row < dimension(); ++row) {
      for (std::size_t column = 0; column < dimension(); ++column) {
        result[i][row] += stretching(row, column) * points[i][column];
      }
      result[i][row] += data_.fold_direction[row] * folded;
    }
  }
  return mirrored_points(std::move(result), data_.mirror);
}

Json ConfigurationMap::json() const {
  Json result;
  if (finite_) {
    for (const auto& [key, list] : {std::pair("points", &finite_->points), std::pair("images", &finite_->images)}) {
      result[key] = Json::array();
      for (const auto& point : *list) result[key].push_back(json_of(point));
    }
    result["distortion"] = exact_text(finite_->distortion);
    return result;
  }
  result["mirror"] = json_of(data_.mirror);
  result["stretching"] = Json::array();
  for (const auto& row : data_.stretching) result["stretching"].push_back(json_of(row));
  result["stretch"] = exact_text(data_.stretch);
  result["fold_direction"] = json_of(data_.fold_direction);
  result["fold_normal"] = json_of(data_.fold_normal);
  result["fold_offset"] = exact_text(data_.fold_offset);
  result["fold"] = exact_text(data_.fold);
  return result;
}

ObjectPointer ConfigurationMap::read(const Json& json) {
  const auto part = [&json](const std::string& key) -> const Json& {
    if (!json.is_object() || !json.contains(key)) throw InputError("a configuration map: " + key + " is missing");
    return json.at(key);
  };
  const auto number = [&part](const std::string& key) {
    if (!part(key).is_string()) throw InputError("a configuration map: " + key + " is not an exact number in quotes");
    return parse_exact(part(key).get<std::string>());
  };
  if (json.is_object() && json.contains("points")) {
    return std::make_shared<ConfigurationMap>(
        Finite{listed_points(part("points"), "points"), listed_points(part("images"), "images"), number("distortion")});
  }
  Data data;
  data.mirror = rationals_from(part("mirror"), "mirror");
  if (!part("stretching").is_array()) throw InputError("a configuration map: stretching is not a list");
  for (const Json& row : part("stretching")) data.stretching.push_back(rationals_from(row, "stretching"));
  data.stretch = number("stretch");
  data.fold_direction = rationals_from(part("fold_direction"), "fold_direction");
  data.fold_normal = rationals_from(part("fold_normal"), "fold_normal");
  data.fold_offset = number("fold_offset");
  data.fold = number("fold");
  return std::make_shared<ConfigurationMap>(std::move(data));
}

}  // namespace delcert
