#include "proofs/drawing/orientation.hpp"

#include <algorithm>
#include <limits>

namespace delcert {

namespace {

/// The sign of the permutation that sorts the vertices of a side, times (−1)^without: the orientation that the simplex
/// induces on the facet, compared with the increasing order.
bool is_induced_positively(const std::vector<std::uint32_t>& simplices, std::size_t size, FacetTable::Side side) {
  bool is_positive = side.without % 2 == 0;
  for (std::size_t j = 0; j < size; ++j) {
    for (std::size_t k = j + 1; k < size; ++k) {
      if (j == side.without || k == side.without) continue;
      if (simplices[side.simplex * size + j] > simplices[side.simplex * size + k]) is_positive = !is_positive;
    }
  }
  return is_positive;
}

}  // namespace

bool orient_coherently(std::vector<std::uint32_t>& simplices, std::size_t size) {
  return orient_coherently(simplices, size, FacetTable(simplices, size));
}

bool orient_coherently(std::vector<std::uint32_t>& simplices, std::size_t size, const FacetTable& facets) {
  struct Neighbour {
    std::uint32_t simplex;
    bool is_same;  ///< whether both are to be turned, or none
  };
  const std::size_t count = simplices.size() / size;
  // Each side has one on either side of it in the table, at most.
  std::vector<Neighbour> neighbours(2 * simplices.size());
  std::vector<std::uint32_t> known(count);
  const auto add = [&](std::uint32_t simplex, const Neighbour& neighbour) {
    neighbours[2 * size * simplex + known[simplex]++] = neighbour;
  };
  for (std::size_t at = 1; at < facets.sides().size(); ++at) {
    if (!facets.is_same_as_before(at)) continue;
    const auto& first = facets.sides()[at - 1];
    const auto& second = facets.sides()[at];
    const bool is_same =
        is_induced_positively(simplices, size, first) != is_induced_positively(simplices, size, second);
    add(first.simplex, {second.simplex, is_same});
    add(second.simplex, {first.simplex, is_same});
  }
  enum class Turn : unsigned char { open, kept, turned };
  std::vector<Turn> turns(count, Turn::open);
  bool is_coherent = true;
  std::vector<std::uint32_t> open;
  for (std::uint32_t start = 0; start < count; ++start) {
    if (turns[start] != Turn::open) continue;
    turns[start] = Turn::kept;
    open.push_back(start);
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < known[at]; ++k) {
        const Neighbour& neighbour = neighbours[2 * size * at + k];
        const Turn wanted = neighbour.is_same == (turns[at] == Turn::kept) ? Turn::kept : Turn::turned;
        Turn& turn = turns[neighbour.simplex];
        if (turn == Turn::open) {
          turn = wanted;
          open.push_back(neighbour.simplex);
        } else if (turn != wanted) {
          is_coherent = false;
        }
      }
    }
  }
  for (std::size_t at = 0; at < count; ++at) {
    if (turns[at] == Turn::turned) std::swap(simplices[at * size + size - 2], simplices[at * size + size - 1]);
  }
  return is_coherent;
}

void reverse_orientation(std::vector<std::uint32_t>& simplices, std::size_t size) {
  for (std::size_t at = 0; at < simplices.size(); at += size)
    std::swap(simplices[at + size - 2], simplices[at + size - 1]);
}

}  // namespace delcert
