#include <algorithm>
#include <numeric>

#include "kernel/stars/approximate_delaunay.hpp"

namespace delcert {

template <>
std::vector<IndexSimplex<1>> approximate_delaunay<1>(const std::vector<Vector<double, 1>>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&points](auto a, auto b) { return std::pair(points[a], a) < std::pair(points[b], b); });
  const auto last =
      std::unique(order.begin(), order.end(), [&points](auto a, auto b) { return points[a] == points[b]; });
  order.erase(last, order.end());
  std::vector<IndexSimplex<1>> result;
  for (std::size_t at = 1; at < order.size(); ++at) {
    result.push_back({std::min(order[at - 1], order[at]), std::max(order[at - 1], order[at])});
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Not worth a triangulation that grows.

template <>
struct GrowingDelaunay<1>::Triangulation {
  std::vector<Vector<double, 1>> points;
};

template <>
GrowingDelaunay<1>::GrowingDelaunay() : triangulation_(std::make_unique<Triangulation>()) {}

template <>
GrowingDelaunay<1>::~GrowingDelaunay() = default;

template <>
void GrowingDelaunay<1>::add(const std::vector<Vector<double, 1>>& points) {
  triangulation_->points.insert(triangulation_->points.end(), points.begin(), points.end());
}

template <>
std::vector<IndexSimplex<1>> GrowingDelaunay<1>::simplices_at(const std::vector<unsigned char>& wanted) const {
  auto result = approximate_delaunay<1>(triangulation_->points);
  std::erase_if(result, [&](const IndexSimplex<1>& simplex) { return !has_vertex_in<1>(simplex, wanted); });
  return result;
}

}  // namespace delcert
