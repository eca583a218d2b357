#include "properties/attack/witness_points.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"
#include "kernel/number/rational.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

bool is_coordinates(const Json& json) {
  return json.is_array() && !json.empty() &&
         std::all_of(json.begin(), json.end(), [](const Json& entry) { return entry.is_string(); });
}

std::vector<double> doubles_of(const Json& coordinates) {
  std::vector<double> result;
  for (const Json& entry : coordinates) result.push_back(approximate_double(parse_exact(entry.get<std::string>())));
  return result;
}

/// Rows of the squares of edges, the first from vertex 1 to vertex 0: columns of a square root of their Gram matrix.
std::vector<std::vector<double>> placed(const Json& rows) {
  const auto k = static_cast<Eigen::Index>(rows.size());
  const auto squared = [&rows](Eigen::Index i, Eigen::Index j) {
    if (i == j) return 0.0;
    const auto row = static_cast<std::size_t>(std::max(i, j) - 1);
    const std::string text = rows.at(row).at(static_cast<std::size_t>(std::min(i, j))).get<std::string>();
    return approximate_double(parse_exact(text));
  };
  Eigen::MatrixXd gram(k, k);
  for (Eigen::Index i = 1; i <= k; ++i) {
    for (Eigen::Index j = 1; j <= k; ++j) gram(i - 1, j - 1) = (squared(i, 0) + squared(j, 0) - squared(i, j)) / 2;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
  const Eigen::MatrixXd root =
      solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() * solver.eigenvectors().transpose();
  std::vector<std::vector<double>> result{std::vector<double>(rows.size(), 0.0)};
  for (Eigen::Index vertex = 0; vertex < k; ++vertex)
    result.emplace_back(root.col(vertex).data(), root.col(vertex).data() + k);
  return result;
}

class Collector {
 public:
  void visit(const std::string& name, bool is_simplex, const Json& part) {
    if (!part.is_structured()) return;
    for (const auto& [key, child] : part.items()) {
      const bool has_lists = child.is_array() && !child.empty() && child.front().is_array();
      if (part.is_object() && key == "point" && is_coordinates(child)) {
        sets.push_back({name, false, {doubles_of(child)}});
      } else if (part.is_object() && (key == "points" || key == "vertices") && has_lists &&
                 std::all_of(child.begin(), child.end(), is_coordinates)) {
        DrawnSet set{name, is_simplex, {}};
        for (const Json& point : child) set.points.push_back(doubles_of(point));
        sets.push_back(std::move(set));
      } else if (part.is_object() && key == "squared_edges" && has_lists) {
        sets.push_back({name, true, placed(child)});
      } else {
        visit(part.is_array() || key == "simplex" || key == "net" ? name : name + " " + key, key == "simplex", child);
      }
    }
  }

  std::vector<DrawnSet> sets;
};

}  // namespace

std::vector<DrawnSet> drawn_sets(const Witness& witness) {
  const Json bindings = bindings_json(witness.bindings, instance_class(witness.instance_class).signature());
  Collector collector;
  for (const auto& [name, value] : bindings.items()) collector.visit(name, false, value);
  // A number beyond the range of doubles has no place on a page.
  std::erase_if(collector.sets, [](const DrawnSet& set) {
    return std::any_of(set.points.begin(), set.points.end(), [](const std::vector<double>& point) {
      return std::any_of(point.begin(), point.end(), [](double x) { return !std::isfinite(x); });
    });
  });
  return collector.sets;
}

}  // namespace delcert
