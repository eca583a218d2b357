#include "kernel/topology/orientation.hpp"

#include <array>
#include <vector>

namespace delcert {

namespace {

/// The first two m-simplices at each face of dimension m − 1, and how many there are.
struct SimplicesAtFacet {
  std::uint32_t count = 0;
  std::array<std::uint32_t, 2> simplex{};
  std::array<bool, 2> negative{};  // whether the face has the coefficient −1 in its boundary
};

std::vector<SimplicesAtFacet> simplices_at_facets(const PureComplex& complex) {
  const int m = complex.dimension();
  std::vector<SimplicesAtFacet> result(complex.count(m - 1));
  for (std::uint32_t simplex = 0; simplex < complex.count(m); ++simplex) {
    bool negative = false;
    for (const std::uint32_t facet : complex.facets(m, simplex)) {
      SimplicesAtFacet& at = result[facet];
      if (at.count < 2) {
        at.simplex[at.count] = simplex;
        at.negative[at.count] = negative;
      }
      ++at.count;
      negative = !negative;
    }
  }
  return result;
}

}  // namespace

FacetDegrees facet_degrees(const PureComplex& complex) {
  FacetDegrees result;
  for (const SimplicesAtFacet& at : simplices_at_facets(complex)) {
    if (at.count == 1) ++result.one;
    if (at.count > 2) ++result.more;
  }
  return result;
}

std::optional<bool> is_orientable(const PureComplex& complex) {
  const int m = complex.dimension();
  const auto facets = simplices_at_facets(complex);
  enum class Orientation : char { unknown, increasing, decreasing };
  std::vector<Orientation> orientations(complex.count(m), Orientation::unknown);
  bool orientable = true;
  std::vector<std::uint32_t> reached;
  for (std::uint32_t first = 0; first < orientations.size(); ++first) {
    if (orientations[first] != Orientation::unknown) continue;
    orientations[first] = Orientation::increasing;
    reached.push_back(first);
    while (!reached.empty()) {
      const std::uint32_t simplex = reached.back();
      reached.pop_back();
      for (const std::uint32_t facet : complex.facets(m, simplex)) {
        const SimplicesAtFacet& at = facets[facet];
        if (at.count > 2) return std::nullopt;
        if (at.count < 2) continue;
        const std::uint32_t other = at.simplex[0] == simplex ? at.simplex[1] : at.simplex[0];
        // Equal coefficients cancel between opposite orientations.
        const bool same = at.negative[0] != at.negative[1];
        const bool increasing = (orientations[simplex] == Orientation::increasing) == same;
        const Orientation expected = increasing ? Orientation::increasing : Orientation::decreasing;
        if (orientations[other] == Orientation::unknown) {
          orientations[other] = expected;
          reached.push_back(other);
        } else if (orientations[other] != expected) {
          orientable = false;
        }
      }
    }
  }
  return orientable;
}

}  // namespace delcert
