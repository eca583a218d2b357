#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "kernel/topology/pure_complex.hpp"

namespace delcert {

/// The number of connected components. Linear time but for the inverse of Ackermann's function.
[[nodiscard]] std::size_t component_count(const PureComplex& complex);

/// The least label of the component of each label; of labels in no simplex themselves. Simplices are lists of labels.
template <class Simplex>
[[nodiscard]] std::vector<std::uint32_t> component_of_labels(std::size_t labels,
                                                             const std::vector<Simplex>& simplices) {
  std::vector<std::uint32_t> parent(labels);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&parent](std::uint32_t label) {
    while (parent[label] != label) label = parent[label] = parent[parent[label]];
    return label;
  };
  for (const Simplex& simplex : simplices) {
    for (const std::uint32_t label : simplex) {
      const std::uint32_t one = root(simplex[0]);
      const std::uint32_t other = root(label);
      parent[std::max(one, other)] = std::min(one, other);
    }
  }
  for (std::uint32_t label = 0; label < labels; ++label) parent[label] = root(label);
  return parent;
}

}  // namespace delcert
