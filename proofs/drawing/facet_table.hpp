#pragma once

#include <cstdint>
#include <vector>

namespace delcert {

/// The facets of simplices, as sorted lists of their vertices.
class FacetTable {
 public:
  struct Side {
    std::uint32_t simplex;
    std::uint32_t without;  ///< which of its vertices the facet is without
  };

  /// Simplices have `size` ≥ 2 vertices each. Keeps a reference.
  FacetTable(const std::vector<std::uint32_t>& simplices, std::size_t size);

  /// All sides, those of one facet one after the other.
  [[nodiscard]] const std::vector<Side>& sides() const { return sides_; }
  /// Whether the side at this place has the same facet as the one before.
  [[nodiscard]] bool is_same_as_before(std::size_t at) const {
    return at > 0 && vertices(sides_[at]) == vertices(sides_[at - 1]);
  }
  [[nodiscard]] std::vector<std::uint32_t> vertices(const Side& side) const;

 private:
  const std::vector<std::uint32_t>& simplices_;
  std::size_t size_;
  std::vector<Side> sides_;
};

}  // namespace delcert
