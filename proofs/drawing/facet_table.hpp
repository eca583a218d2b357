#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace delcert {

/// The facets of simplices, as sorted lists of their vertices.
class FacetTable {
 public:
  struct Side {
    std::uint32_t simplex;
    std::uint32_t without;  ///< which of its vertices the facet is without
  };

  /// Simplices have `size` ≥ 2 vertices each, in any order.
  FacetTable(const std::vector<std::uint32_t>& simplices, std::size_t size);

  /// All sides, those of one facet one after the other.
  [[nodiscard]] const std::vector<Side>& sides() const { return sides_; }
  /// Whether the side at this place has the same facet as the one before.
  [[nodiscard]] bool is_same_as_before(std::size_t at) const {
    return at > 0 && std::equal(vertices(at).begin(), vertices(at).end(), vertices(at - 1).begin());
  }
  /// Of the side at this place, in increasing order.
  [[nodiscard]] std::span<const std::uint32_t> vertices(std::size_t at) const {
    return std::span(vertices_).subspan(at * length_, length_);
  }

 private:
  std::size_t length_;  ///< vertices of a facet
  std::vector<Side> sides_;
  std::vector<std::uint32_t> vertices_;
};

}  // namespace delcert
