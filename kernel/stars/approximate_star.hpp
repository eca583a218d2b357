#pragma once

#include "kernel/stars/approximate_delaunay.hpp"

namespace delcert {

/// The simplices of `approximate_delaunay` that have the point with this number, likewise a proposal. Where that point
/// is certainly inside of the hull of the others, no other is much nearer than the rest, and nothing is nearly
/// cospherical, they are found without triangulating the other points.
///
/// The inversion y ↦ y/|y|² about the point takes the spheres through it to planes, so its simplices are the facets of
/// the hull of the images; facets are wrapped around edges, and each is checked to have all other images clearly on one
/// side. Precondition: rounding to nearest; the point is one of them.
template <int m>
[[nodiscard]] std::vector<IndexSimplex<m>> approximate_star(const std::vector<Vector<double, m>>& points,
                                                            std::uint32_t home);

}  // namespace delcert
