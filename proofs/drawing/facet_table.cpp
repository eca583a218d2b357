#include "proofs/drawing/facet_table.hpp"

#include <algorithm>

namespace delcert {

FacetTable::FacetTable(const std::vector<std::uint32_t>& simplices, std::size_t size)
    : simplices_(simplices), size_(size) {
  struct Keyed {
    std::vector<std::uint32_t> vertices;
    Side side;
  };
  std::vector<Keyed> keyed;
  keyed.reserve(simplices.size());
  for (std::uint32_t simplex = 0; simplex < simplices.size() / size; ++simplex) {
    for (std::uint32_t without = 0; without < size; ++without) {
      const Side side{simplex, without};
      keyed.push_back({vertices(side), side});
    }
  }
  std::stable_sort(keyed.begin(), keyed.end(), [](const Keyed& a, const Keyed& b) { return a.vertices < b.vertices; });
  for (const Keyed& entry : keyed) sides_.push_back(entry.side);
}

std::vector<std::uint32_t> FacetTable::vertices(const Side& side) const {
  std::vector<std::uint32_t> result;
  result.reserve(size_ - 1);
  for (std::size_t k = 0; k < size_; ++k) {
    if (k != side.without) result.push_back(simplices_[side.simplex * size_ + k]);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace delcert
