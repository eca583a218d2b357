#pragma once

#include <optional>
#include <vector>

#include "proofs/drawing/manifold/approximate_manifold.hpp"

namespace delcert {

/// What can be said of each simplex, in the order of the certificate: doubles, without error bounds; NaN where a
/// simplex cannot be measured. Lengths are in units of ε, or of the ε_i where radii vary.
struct SimplexMeasures {
  /// The least in the charts of its vertices: how much farther than the circumradius the nearest other point is from
  /// the circumcentre. Points that are looked at are the neighbours of neighbours: on a Delaunay complex the nearest is
  /// among them.
  std::vector<double> protection;
  std::vector<double> thickness;     ///< the least in the charts of its vertices
  std::vector<double> circumradius;  ///< the greatest in the charts of its vertices
  /// The least over its facets of the sum over both simplices there of the cotangents of the angles opposite (m = 2),
  /// or of the heights of the circumcentres over it: positive where the piecewise flat metric is Delaunay. Empty where
  /// no such metric is spoken of.
  std::vector<double> hinge;
};

[[nodiscard]] SimplexMeasures measure_simplices(ApproximateManifold& manifold,
                                                const std::vector<DrawnSimplex>& simplices, std::size_t labels);

}  // namespace delcert
