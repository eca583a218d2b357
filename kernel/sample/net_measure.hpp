#pragma once

#include <optional>
#include <vector>

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/stars/proposal.hpp"
#include "support/progress.hpp"

namespace delcert {

/// How dense a net is, certified.
template <int m>
struct NetDensity {
  /// covering_radius_lower ≤ sup over the manifold (the ball) of the distance to the net < sampling_radius.
  Rational covering_radius_lower;
  Rational sampling_radius;
  /// The witness: oriented simplices that cover, each with its vertices in an open ball of that radius
  /// (docs/levels/0-input.md).
  std::vector<LiftedSimplex<m>> simplices;
};

/// Measures the covering radius of a net through a triangulation of it, made from a copy of the points displaced by
/// less than 2⁻³¹, so that cospherical points are triangulated the same way wherever they are seen. Nothing is assumed
/// of that triangulation but what is checked: the balls, and that its simplices cover.
///
/// `nominal`: the radius the net was made for; it is taken as the sampling radius if it is one and exceeds the
/// covering radius by at most a factor 1.001, otherwise a tight upper bound is. On a ball it also has to exceed the
/// circumradii of the simplices that meet the ball, whose centres may lie beyond it, and may be larger for that.
/// `known`: a Delaunay triangulation of the points as they are, which is tried first; empty if none is known.
/// Throws Rejection when the density cannot be certified, saying where, InputError unless the nominal radius is above
/// 0.
template <int m>
[[nodiscard]] NetDensity<m> measure_density(const FlatSpace<m>& space, const PointSet<m>& net,
                                            const std::optional<Rational>& nominal, const Progress& progress,
                                            const std::vector<LiftedSimplex<m>>& known = {});

}  // namespace delcert
