#include <algorithm>
#include <numeric>

#include "kernel/stars/growing_delaunay.hpp"

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

template <>
struct GrowingDelaunay<1>::Triangulation : RemadeDelaunay<1> {};
template class GrowingDelaunay<1>;

}  // namespace delcert
