#pragma once

#include "proofs/drawing/drawing.hpp"
#include "proofs/drawing/facet_table.hpp"

namespace delcert {

/// Which copies of labels and simplices there are in a drawing, without coordinates.
struct Layout {
  struct Vertex {
    std::uint32_t label;
    std::uint32_t sheet;
    friend auto operator<=>(const Vertex&, const Vertex&) = default;
  };
  std::vector<Vertex> vertices;          ///< by labels, then by sheets
  std::vector<std::uint32_t> simplices;  ///< m + 1 vertices each, in the order of their labels
  std::vector<std::uint32_t> positions;  ///< of each simplex, in the certificate's list
};

[[nodiscard]] Layout layout_of(ApproximateManifold& manifold, const std::vector<DrawnSimplex>& simplices,
                               std::size_t labels, DrawingCopies copies);

/// Pairs of facets with the same labels, each in one simplex of the layout; its facets are known.
[[nodiscard]] std::vector<MatchingFaces> matching_faces(ApproximateManifold& manifold, const Layout& layout,
                                                        const FacetTable& facets);

}  // namespace delcert
