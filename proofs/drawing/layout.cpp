#include "proofs/drawing/layout.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "proofs/drawing/facet_table.hpp"

namespace delcert {

namespace {

/// Copies of simplices: their positions, and the sheets on which they are.
struct PlacedCopies {
  std::vector<std::uint32_t> positions;
  std::vector<std::vector<Layout::Vertex>> vertices;
};

class CopySearch {
 public:
  CopySearch(ApproximateManifold& manifold, const std::vector<DrawnSimplex>& simplices)
      : manifold_(manifold), simplices_(simplices) {}

  void add_quotient() {
    for (const DrawnSimplex& simplex : simplices_) {
      std::vector<Layout::Vertex> vertices;
      for (const std::uint32_t label : simplex.labels) vertices.push_back({label, manifold_.home_sheet(label)});
      add(simplex, std::move(vertices));
    }
  }

  void add_cell() {
    for (const DrawnSimplex& simplex : simplices_) add_on(simplex, manifold_.cell_sheet(simplex));
  }

  /// Copies that share a vertex with those that are there.
  void add_around(std::size_t labels) {
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> stars(labels);
    for (const DrawnSimplex& simplex : simplices_) {
      for (std::size_t k = 0; k < simplex.labels.size(); ++k)
        stars[simplex.labels[k]].emplace_back(simplex.position, k);
    }
    std::set<Layout::Vertex> centres;
    for (const auto& vertices : copies_.vertices) centres.insert(vertices.begin(), vertices.end());
    for (const Layout::Vertex& centre : centres) {
      for (const auto& [position, k] : stars[centre.label]) {
        const DrawnSimplex& simplex = simplices_[position];
        add_on(simplex, manifold_.simplex_sheet(centre.sheet, simplex.elements[k]));
      }
    }
  }

  [[nodiscard]] const PlacedCopies& copies() const { return copies_; }

 private:
  void add_on(const DrawnSimplex& simplex, std::uint32_t sheet) {
    if (!placed_.insert({simplex.position, sheet}).second) return;
    std::vector<Layout::Vertex> vertices;
    for (std::size_t k = 0; k < simplex.labels.size(); ++k) {
      vertices.push_back({simplex.labels[k], manifold_.vertex_sheet(sheet, simplex.elements[k])});
      // A chart may not show all of it.
      if (!manifold_.place(vertices.back().label, vertices.back().sheet)) return;
    }
    add(simplex, std::move(vertices));
  }

  void add(const DrawnSimplex& simplex, std::vector<Layout::Vertex> vertices) {
    copies_.positions.push_back(static_cast<std::uint32_t>(simplex.position));
    copies_.vertices.push_back(std::move(vertices));
  }

  ApproximateManifold& manifold_;
  const std::vector<DrawnSimplex>& simplices_;
  std::set<std::pair<std::size_t, std::uint32_t>> placed_;
  PlacedCopies copies_;
};

}  // namespace

Layout layout_of(ApproximateManifold& manifold, const std::vector<DrawnSimplex>& simplices, std::size_t labels,
                 DrawingCopies copies) {
  CopySearch search(manifold, simplices);
  if (copies == DrawingCopies::quotient) search.add_quotient();
  if (copies != DrawingCopies::quotient) search.add_cell();
  if (copies == DrawingCopies::glued) search.add_around(labels);
  Layout result;
  for (const auto& vertices : search.copies().vertices)
    result.vertices.insert(result.vertices.end(), vertices.begin(), vertices.end());
  if (copies == DrawingCopies::quotient) {
    // Of a ball there may be points in no simplex.
    result.vertices.clear();
    for (std::uint32_t label = 0; label < labels; ++label)
      result.vertices.push_back({label, manifold.home_sheet(label)});
  }
  std::sort(result.vertices.begin(), result.vertices.end());
  result.vertices.erase(std::unique(result.vertices.begin(), result.vertices.end()), result.vertices.end());
  for (const auto& vertices : search.copies().vertices) {
    for (const Layout::Vertex& vertex : vertices) {
      const auto found = std::lower_bound(result.vertices.begin(), result.vertices.end(), vertex);
      result.simplices.push_back(static_cast<std::uint32_t>(found - result.vertices.begin()));
    }
  }
  result.positions = search.copies().positions;
  return result;
}

std::vector<MatchingFaces> matching_faces(ApproximateManifold& manifold, const Layout& layout) {
  const std::size_t size = layout.positions.empty() ? 0 : layout.simplices.size() / layout.positions.size();
  if (size < 2) return {};
  const FacetTable facets(layout.simplices, size);
  // Vertices are in the order of their labels, so the vertices of copies correspond.
  std::map<std::vector<std::uint32_t>, std::vector<std::vector<std::uint32_t>>> open;
  for (std::size_t at = 0; at < facets.sides().size(); ++at) {
    if (facets.is_same_as_before(at) || (at + 1 < facets.sides().size() && facets.is_same_as_before(at + 1))) continue;
    const std::vector<std::uint32_t> vertices = facets.vertices(facets.sides()[at]);
    std::vector<std::uint32_t> labels;
    for (const std::uint32_t vertex : vertices) labels.push_back(layout.vertices[vertex].label);
    open[labels].push_back(vertices);
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
