#include "proofs/drawing/facet_table.hpp"

#include "kernel/topology/lexicographic_order.hpp"

namespace delcert {

FacetTable::FacetTable(const std::vector<std::uint32_t>& simplices, std::size_t size) : length_(size - 1) {
  struct Corner {
    std::uint32_t vertex;
    std::uint32_t place;
    bool operator<(const Corner& other) const { return vertex < other.vertex; }
  };
  std::vector<Side> sides;
  std::vector<std::uint32_t> vertices;
  sides.reserve(simplices.size());
  vertices.reserve(simplices.size() * length_);
  std::vector<Corner> corners(size);
  std::uint32_t greatest = 0;
  for (std::uint32_t simplex = 0; simplex < simplices.size() / size; ++simplex) {
    for (std::uint32_t place = 0; place < size; ++place) corners[place] = {simplices[simplex * size + place], place};
    std::sort(corners.begin(), corners.end());
    greatest = std::max(greatest, corners.back().vertex);
    for (const Corner& without : corners) {
      sides.push_back({simplex, without.place});
      for (const Corner& corner : corners) {
        if (corner.place != without.place) vertices.push_back(corner.vertex);
      }
    }
  }
  sides_.reserve(sides.size());
  vertices_.reserve(vertices.size());
  const auto vertex = [&](std::size_t side, std::size_t place) { return vertices[side * length_ + place]; };
  for (const std::size_t side : lexicographic_order(sides.size(), length_, std::size_t{greatest} + 1, vertex)) {
    sides_.push_back(sides[side]);
    for (std::size_t place = 0; place < length_; ++place) vertices_.push_back(vertex(side, place));
  }
}

}  // namespace delcert
