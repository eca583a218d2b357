#pragma once

#include <limits>
#include <vector>

#include "kernel/manifold/space_form/curved_functions.hpp"
#include "kernel/sample/counter_random.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// The Voronoi cell of a point of a model space among others about it, and where it is too wide. Without error bounds,
/// in doubles; needs rounding to nearest.
///
/// The other points come in conformal coordinates with the point itself at 0. These take spheres to spheres, so the
/// Delaunay simplices at the point are the Euclidean ones, and a sphere through 0 of Euclidean radius ρ has the radius
/// R with tan R = ρ (curvature 0: R = ρ; −1: tanh R = ρ).
template <int m>
class VoronoiGaps {
 public:
  /// Of how many radii about the point the others have to be known.
  static constexpr double reach = 2.25;

  VoronoiGaps(Curvature curvature, double radius);

  struct Found {
    /// For every vertex of the cell that is farther than the radius, by a relative 2⁻²⁸, a random point that is farther
    /// than the radius from all that are given.
    std::vector<Vector<double, m>> points;
    /// The distance of the farthest vertex.
    double farthest_vertex = 0;
    /// The distance of the nearest other point; infinite if there is none.
    double nearest = std::numeric_limits<double>::infinity();
  };
  [[nodiscard]] Found find(const std::vector<Vector<double, m>>& others, CounterRandom& random) const;

 private:
  /// tan, 1·, tanh of a length, and the length again.
  [[nodiscard]] double tangent(double length) const;
  [[nodiscard]] double length_of_tangent(double tangent) const;
  [[nodiscard]] Vector<double, m> point_towards(const Vector<double, m>& centre, double gap,
                                                CounterRandom& random) const;

  Curvature curvature_;
  double least_tangent_;  // of a gap
  double most_tangent_;   // of half the reach: balls through the point of that radius are known to be empty
  /// So far out that a ball through the point and one of them is no smaller than that; they close the cell.
  std::vector<Vector<double, m>> fence_;
};

}  // namespace delcert
