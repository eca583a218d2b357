#include "proofs/formula/simplex_object.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "kernel/number/exact_text.hpp"
#include "kernel/simplex/realisability.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

SimplexObject::Points checked(SimplexObject::Points points) {
  if (points.empty()) throw std::invalid_argument("a simplex needs at least one vertex");
  for (const auto& point : points) {
    if (point.empty() || point.size() != points.front().size()) {
      throw std::invalid_argument("points of different dimensions, or of dimension 0");
    }
  }
  return points;
}

EdgeGram<Rational> checked_gram(const SymmetricMatrix<Rational>& squared_edges) {
  for (std::size_t i = 0; i < squared_edges.order(); ++i) {
    if (!is_proved(is_zero(squared_edges(i, i)))) throw std::invalid_argument("a vertex away from itself");
  }
  auto result = edge_gram_from_squared_edges(squared_edges);
  if (!is_proved(is_realisable(result, result.dimension()))) {
    throw std::invalid_argument("no simplex has these edge lengths");
  }
  return result;
}

std::vector<std::vector<Rational>> rows_from(const Json& json, const std::string& where) {
  if (!json.is_array() || json.empty()) throw InputError(where + " is not a list of lists of exact numbers");
  std::vector<std::vector<Rational>> result;
  for (const Json& row : json) result.push_back(rationals_from(row, where));
  return result;
}

}  // namespace

Json json_of(const std::vector<Rational>& numbers) {
  Json result = Json::array();
  for (const Rational& number : numbers) result.push_back(exact_text(number));
  return result;
}

std::vector<Rational> rationals_from(const Json& json, const std::string& where) {
  if (!json.is_array()) throw InputError(where + " is not a list of exact numbers");
  std::vector<Rational> result;
  for (const Json& number : json) {
    if (!number.is_string()) throw InputError(where + " has an entry that is not an exact number in quotes");
    result.push_back(parse_exact(number.get<std::string>()));
  }
  return result;
}

SimplexObject::SimplexObject(Points points)
    : points_(checked(std::move(points))), gram_(edge_gram_from_points(points_)) {}

SimplexObject::SimplexObject(const SymmetricMatrix<Rational>& squared_edges) : gram_(checked_gram(squared_edges)) {}

std::size_t SimplexObject::ambient_dimension() const {
  return has_coordinates() ? points_.front().size() : dimension();
}

SimplexObject SimplexObject::face(std::span<const std::size_t> vertices) const {
  Points points;
  for (const std::size_t vertex : vertices) {
    if (vertex >= vertex_count()) throw std::out_of_range("a face of a vertex that is not there");
    if (has_coordinates()) points.push_back(points_[vertex]);
  }
  return {std::move(points), gram_.face(vertices)};
}

Json SimplexObject::json() const {
  Json result;
  if (has_coordinates()) {
    result["points"] = Json::array();
    for (const auto& point : points_) result["points"].push_back(json_of(point));
    return result;
  }
  result["squared_edges"] = Json::array();
  for (std::size_t i = 1; i < vertex_count(); ++i) {
    std::vector<Rational> row;
    for (std::size_t j = 0; j < i; ++j) row.push_back(gram_.squared_edge(i, j));
    result["squared_edges"].push_back(json_of(row));
  }
  return result;
}

ObjectPointer SimplexObject::read(const Json& json) {
  try {
    if (json.contains("points")) return std::make_shared<SimplexObject>(rows_from(json.at("points"), "points"));
    if (!json.contains("squared_edges")) throw InputError("a simplex has points or squared_edges");
    const auto rows = rows_from(json.at("squared_edges"), "squared_edges");
    SymmetricMatrix<Rational> squared_edges(rows.size() + 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].size() != i + 1)
        throw InputError("row " + std::to_string(i + 1) + " of squared_edges is not of " + std::to_string(i + 1) +
                         " numbers");
      for (std::size_t j = 0; j <= i; ++j) squared_edges(i + 1, j) = rows[i][j];
    }
    return std::make_shared<SimplexObject>(squared_edges);
  } catch (const std::invalid_argument& error) {
    throw InputError(std::string("a simplex: ") + error.what());
  }
}

Json PointObject::json() const { return json_of(coordinates_); }

ObjectPointer PointObject::read(const Json& json) {
  return std::make_shared<PointObject>(rationals_from(json, "a point"));
}

}  // namespace delcert
