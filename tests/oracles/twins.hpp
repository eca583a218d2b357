#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "tests/oracles/cgal_delaunay.hpp"

// What an oracle must notice.
namespace delcert::test {

namespace detail {

template <int m>
struct FacetOfSimplex {
  std::size_t opposite;
  std::vector<Lift<m>> vertices;
  Lift<m> apex;
};

/// The facet opposite a corner, the simplex being moved by a lattice vector.
template <int m>
FacetOfSimplex<m> facet_of(const LiftedSimplex<m>& simplex, std::size_t opposite, const Shift<m>& by) {
  FacetOfSimplex<m> result{opposite, {}, {}};
  for (std::size_t corner = 0; corner <= m; ++corner) {
    const Lift<m> lift{simplex[corner].index, sum_of<m>(simplex[corner].shift, by)};
    if (corner == opposite) {
      result.apex = lift;
    } else {
      result.vertices.push_back(lift);
    }
  }
  return result;
}

/// The facet of the other simplex at this facet, moved to where the first one is; none if this is that facet.
template <int m>
std::optional<FacetOfSimplex<m>> other_side(const FacetOfSimplex<m>& facet, const LiftedSimplex<m>& simplex) {
  for (std::size_t opposite = 0; opposite <= m; ++opposite) {
    const auto unmoved = facet_of<m>(simplex, opposite, {});
    const Shift<m> by = difference_of<m>(facet.vertices[0].shift, unmoved.vertices[0].shift);
    auto candidate = facet_of<m>(simplex, opposite, by);
    if (candidate.vertices == facet.vertices && candidate.apex != facet.apex) return candidate;
  }
  return std::nullopt;
}

/// The segment between two apexes joined with each face of codimension 1 of the facet.
template <int m>
Complex<m> around_segment(const std::vector<Lift<m>>& facet, const Lift<m>& one, const Lift<m>& other) {
  Complex<m> result;
  for (std::size_t replaced = 0; replaced < m; ++replaced) {
    LiftedSimplex<m> simplex;
    std::copy(facet.begin(), facet.end(), simplex.begin());
    simplex[replaced] = one;
    simplex[m] = other;
    result.push_back(canonical<m>(simplex));
  }
  return result;
}

}  // namespace detail

/// The complex after one bistellar flip: two simplices at a facet give way to the m simplices at the segment between
/// their apexes. In dimension 2 that flips an edge. What comes out is closed again, so that counting the simplices at
/// each facet does not notice.
template <int m>
Complex<m> with_one_flip(Complex<m> simplices) {
  const LiftedSimplex<m> first = simplices.front();
  const auto facet = detail::facet_of<m>(first, 0, {});
  for (const LiftedSimplex<m>& second : simplices) {
    const auto beyond = detail::other_side<m>(facet, second);
    if (!beyond) continue;
    const LiftedSimplex<m> gone = second;
    std::erase_if(simplices, [&](const auto& simplex) { return simplex == first || simplex == gone; });
    const auto added = detail::around_segment<m>(facet.vertices, facet.apex, beyond->apex);
    simplices.insert(simplices.end(), added.begin(), added.end());
    sort_and_unite<m>(simplices);
    return simplices;
  }
  ADD_FAILURE() << "the first simplex has no neighbour at its first facet";
  return simplices;
}

/// The points with one of them moved along the first axis.
template <int m>
Doubles<m> with_one_point_moved(Doubles<m> points, std::size_t index, double by) {
  points.at(index)[0] += by;
  return points;
}

}  // namespace delcert::test
