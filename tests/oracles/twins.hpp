#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "kernel/stars/approximate_sphere.hpp"
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
  // Copies, as the list changes before they have been used.
  for (LiftedSimplex<m> first : simplices) {
    const auto facet = detail::facet_of<m>(first, 0, {});
    for (LiftedSimplex<m> second : simplices) {
      const auto beyond = detail::other_side<m>(facet, second);
      if (!beyond) continue;
      std::erase_if(simplices, [&](const auto& simplex) { return simplex == first || simplex == second; });
      const auto added = detail::around_segment<m>(facet.vertices, facet.apex, beyond->apex);
      simplices.insert(simplices.end(), added.begin(), added.end());
      sort_and_unite<m>(simplices);
      return simplices;
    }
  }
  ADD_FAILURE() << "no two simplices share a facet";
  return simplices;
}

/// The points with one of them moved by `distance` so that it gets into the ball of a simplex that it is no vertex of:
/// that simplex is then no Delaunay simplex. The first vertex beyond a first facet that is near enough is moved.
template <int m>
Doubles<m> with_one_point_in_a_ball(Doubles<m> points, const FrameMetric<m>& metric, const Complex<m>& simplices,
                                    double distance) {
  const auto plain = metric.template on<PlainDouble>();
  const auto position = [&points](const Lift<m>& lift) {
    Vector<double, m> x = points[lift.index];
    for (std::size_t axis = 0; axis < m; ++axis) x[axis] += lift.shift[axis];
    return x;
  };
  // Copies, as the list changes before they have been used.
  for (LiftedSimplex<m> first : simplices) {
    std::array<Vector<double, m>, corner_count<m>> vertices;
    for (std::size_t corner = 0; corner <= m; ++corner) vertices[corner] = position(first[corner]);
    const auto sphere = approximate_sphere<m>(plain, vertices);
    for (LiftedSimplex<m> second : simplices) {
      const auto beyond = detail::other_side<m>(detail::facet_of<m>(first, 0, {}), second);
      if (!beyond) continue;
      Vector<PlainDouble, m> inwards;
      const Vector<double, m> apex = position(beyond->apex);
      for (std::size_t axis = 0; axis < m; ++axis)
        inwards[axis] = PlainDouble::exactly(sphere.centre[axis] - apex[axis]);
      const double to_centre = square_root(plain.squared_norm(inwards)).lower();
      if (to_centre - distance > std::sqrt(sphere.squared_radius) - distance / 100) break;
      for (std::size_t axis = 0; axis < m; ++axis) {
        points[beyond->apex.index][axis] += distance / to_centre * inwards[axis].lower();
      }
      return points;
    }
  }
  ADD_FAILURE() << "no vertex is near enough to a ball";
  return points;
}

/// A third of the sampling radius.
template <int m>
double third_of_radius(const FlatAtlas<m>& atlas) {
  return approximate_double(atlas.sampling_radius()) / 3;
}

}  // namespace delcert::test
