#include "proofs/drawing/layout.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace delcert {

namespace {

/// Copies of simplices: their positions, and the vertices of one after those of the other.
struct PlacedCopies {
  std::vector<std::uint32_t> positions;
  std::vector<Layout::Vertex> vertices;
};

class CopySearch {
 public:
  CopySearch(ApproximateManifold& manifold, const std::vector<DrawnSimplex>& simplices)
      : manifold_(manifold), simplices_(simplices) {
    copies_.positions.reserve(simplices.size());
    if (!simplices.empty()) copies_.vertices.reserve(simplices.size() * simplices[0].labels.size());
  }

  void add_quotient() {
    for (const DrawnSimplex& simplex : simplices_) {
      for (const std::uint32_t label : simplex.labels) copies_.vertices.push_back({label, manifold_.home_sheet(label)});
      copies_.positions.push_back(static_cast<std::uint32_t>(simplex.position));
    }
  }

  void add_cell() {
    for (const DrawnSimplex& simplex : simplices_) add_on(simplex, manifold_.cell_sheet(simplex));
  }

  /// Copies that share a vertex with those that are there.
  void add_around(std::size_t labels) {
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> stars(labels);
    std::set<std::pair<std::size_t, std::uint32_t>> placed;
    for (const DrawnSimplex& simplex : simplices_) {
      for (std::size_t k = 0; k < simplex.labels.size(); ++k)
        stars[simplex.labels[k]].emplace_back(simplex.position, k);
      placed.emplace(simplex.position, manifold_.cell_sheet(simplex));
    }
    const std::set<Layout::Vertex> centres(copies_.vertices.begin(), copies_.vertices.end());
    for (const Layout::Vertex& centre : centres) {
      for (const auto& [position, k] : stars[centre.label]) {
        const DrawnSimplex& simplex = simplices_[position];
        const std::uint32_t sheet = manifold_.simplex_sheet(centre.sheet, simplex.elements[k]);
        if (placed.emplace(position, sheet).second) add_on(simplex, sheet);
      }
    }
  }

  [[nodiscard]] PlacedCopies copies() && { return std::move(copies_); }

 private:
  void add_on(const DrawnSimplex& simplex, std::uint32_t sheet) {
    const std::size_t before = copies_.vertices.size();
    for (std::size_t k = 0; k < simplex.labels.size(); ++k) {
      const Layout::Vertex vertex{simplex.labels[k], manifold_.vertex_sheet(sheet, simplex.elements[k])};
      // A chart may not show all of it.
      if (!manifold_.place(vertex.label, vertex.sheet)) return copies_.vertices.resize(before);
      copies_.vertices.push_back(vertex);
    }
    copies_.positions.push_back(static_cast<std::uint32_t>(simplex.position));
  }

  ApproximateManifold& manifold_;
  const std::vector<DrawnSimplex>& simplices_;
  PlacedCopies copies_;
};

/// The sheets on which there are copies of each label: few, so that a list is searched faster than a tree.
class SheetsOfLabels {
 public:
  SheetsOfLabels(std::size_t labels, const std::vector<Layout::Vertex>& vertices) : sheets_(labels), first_(labels) {
    for (const Layout::Vertex& vertex : vertices) {
      std::vector<std::uint32_t>& list = sheets_[vertex.label];
      if (std::find(list.begin(), list.end(), vertex.sheet) == list.end()) list.push_back(vertex.sheet);
    }
    std::uint32_t next = 0;
    for (std::size_t label = 0; label < labels; ++label) {
      std::sort(sheets_[label].begin(), sheets_[label].end());
      first_[label] = next;
      next += static_cast<std::uint32_t>(sheets_[label].size());
    }
  }

  /// By labels, then by sheets.
  [[nodiscard]] std::vector<Layout::Vertex> vertices() const {
    std::vector<Layout::Vertex> result;
    for (std::uint32_t label = 0; label < sheets_.size(); ++label) {
      for (const std::uint32_t sheet : sheets_[label]) result.push_back({label, sheet});
    }
    return result;
  }
  /// The place among them. Precondition: it is one of them.
  [[nodiscard]] std::uint32_t place_of(const Layout::Vertex& vertex) const {
    const std::vector<std::uint32_t>& list = sheets_[vertex.label];
    return first_[vertex.label] +
           static_cast<std::uint32_t>(std::find(list.begin(), list.end(), vertex.sheet) - list.begin());
  }

 private:
  std::vector<std::vector<std::uint32_t>> sheets_;
  std::vector<std::uint32_t> first_;
};

}  // namespace

Layout layout_of(ApproximateManifold& manifold, const std::vector<DrawnSimplex>& simplices, std::size_t labels,
                 DrawingCopies copies) {
  CopySearch search(manifold, simplices);
  if (copies == DrawingCopies::quotient) search.add_quotient();
  if (copies != DrawingCopies::quotient) search.add_cell();
  if (copies == DrawingCopies::glued) search.add_around(labels);
  PlacedCopies placed = std::move(search).copies();
  std::vector<Layout::Vertex> present = placed.vertices;
  if (copies == DrawingCopies::quotient) {
    // Of a ball there may be points in no simplex.
    present.clear();
    for (std::uint32_t label = 0; label < labels; ++label) present.push_back({label, manifold.home_sheet(label)});
  }
  const SheetsOfLabels sheets(labels, present);
  Layout result;
  result.vertices = sheets.vertices();
  result.simplices.reserve(placed.vertices.size());
  for (const Layout::Vertex& vertex : placed.vertices) result.simplices.push_back(sheets.place_of(vertex));
  result.positions = std::move(placed.positions);
  return result;
}

std::vector<MatchingFaces> matching_faces(ApproximateManifold& manifold, const Layout& layout,
                                          const FacetTable& facets) {
  // Vertices are in the order of their labels, so the vertices of copies correspond.
  std::map<std::vector<std::uint32_t>, std::vector<std::vector<std::uint32_t>>> open;
  for (std::size_t at = 0; at < facets.sides().size(); ++at) {
    if (facets.is_same_as_before(at) || (at + 1 < facets.sides().size() && facets.is_same_as_before(at + 1))) continue;
    const auto vertices = facets.vertices(at);
    std::vector<std::uint32_t> labels;
    for (const std::uint32_t vertex : vertices) labels.push_back(layout.vertices[vertex].label);
    open[labels].emplace_back(vertices.begin(), vertices.end());
  }
  std::vector<MatchingFaces> result;
  for (const auto& [labels, copies] : open) {
    if (copies.size() != 2) continue;
    result.push_back({copies[0], copies[1],
                      manifold.step_text(layout.vertices[copies[0][0]].sheet, layout.vertices[copies[1][0]].sheet)});
  }
  return result;
}

}  // namespace delcert
