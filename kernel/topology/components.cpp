#include "kernel/topology/components.hpp"

#include <numeric>
#include <vector>

namespace delcert {

std::size_t component_count(const PureComplex& complex) {
  std::vector<std::uint32_t> parent(complex.count(0));
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&parent](std::uint32_t vertex) {
    while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
    return vertex;
  };
  std::size_t components = parent.size();
  for (std::size_t edge = 0; edge < complex.count(1); ++edge) {
    const auto ends = complex.vertices(1, edge);
    const std::uint32_t one = root(ends[0]), other = root(ends[1]);
    if (one == other) continue;
    parent[one] = other;
    --components;
  }
  return components;
}

}  // namespace delcert
