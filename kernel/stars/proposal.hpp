#pragma once

#include <vector>

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/stars/approximate_delaunay.hpp"

namespace delcert {

/// An m-simplex of lifted points, up to translation: vertices in increasing order, the first with shift 0.
template <int m>
using LiftedSimplex = std::array<Lift<m>, static_cast<std::size_t>(m) + 1>;

/// The same simplex in its canonical form.
template <int m>
[[nodiscard]] LiftedSimplex<m> canonical(LiftedSimplex<m> simplex);

/// The Delaunay simplices of the lifts of these points (approximate frame coordinates), each once mod the lattice, in
/// increasing order. A proposal: nothing is certified. On a torus copies of the points around the unit cell stand in
/// for the lifts; their number grows, from what the usual circumradius (> 0) asks for, until every proposed circumball
/// is well inside.
/// Throws Rejection when the points are too few for that, or span no m-simplex, InputError for coordinates of 2³⁰ or
/// more, and for a lattice basis so skewed that copies do not reach; the message has a reduced one.
template <int m>
[[nodiscard]] std::vector<LiftedSimplex<m>> propose_delaunay(const FlatSpace<m>& space,
                                                             const std::vector<Vector<double, m>>& points,
                                                             double usual_circumradius);

}  // namespace delcert
