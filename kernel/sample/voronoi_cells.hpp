#pragma once

#include <limits>
#include <vector>

#include "kernel/chart/curved_functions.hpp"
#include "kernel/random/counter_random.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// Voronoi cells of points of a model space, each from the others about it; without error bounds, in doubles. Needs
/// rounding to nearest.
///
/// The other points come in conformal coordinates with the point itself at 0. These take spheres to spheres, so the
/// Delaunay simplices at the point are the Euclidean ones, and a sphere through 0 of Euclidean radius ρ has the radius
/// R with tan R = ρ (curvature 0: R = ρ; −1: tanh R = ρ).
template <int m>
class VoronoiCells {
 public:
  /// `reach`: how far the others are known. Cells are cut off where balls about their vertices are not known to be
  /// empty, at half of it.
  VoronoiCells(Curvature curvature, double reach);

  struct Cell {
    /// The vertices, each by the Euclidean centre of the sphere about it through 0.
    std::vector<Vector<double, m>> sphere_centres;
    /// The distances of the farthest vertex, cut off, and of the nearest other point, infinite if there is none.
    double farthest_vertex = 0;
    double nearest = std::numeric_limits<double>::infinity();
    /// Whether it is cut off somewhere.
    bool is_cut_off = false;
    /// The simplices at the point that it belongs to, by their other vertices.
    std::vector<std::array<Vector<double, m>, static_cast<std::size_t>(m)>> simplices;
  };
  [[nodiscard]] Cell cell(const std::vector<Vector<double, m>>& others) const;

  /// The mass centre of a cell as a Euclidean one with the circumcentres in conformal coordinates; of a cell that is
  /// cut off 0.
  [[nodiscard]] static Vector<double, m> mass_centre(const Cell& cell);

  /// For every vertex that is farther than the radius, by a relative 2⁻²⁸, a random point near it that is farther than
  /// the radius from all points given. Precondition: the radius is less than half of the reach.
  [[nodiscard]] std::vector<Vector<double, m>> points_in_gaps(const Cell& cell, double radius,
                                                              CounterRandom& random) const;

 private:
  /// tan, 1·, tanh of a length, and the length again.
  [[nodiscard]] double tangent(double length) const;
  [[nodiscard]] double length_of_tangent(double tangent) const;
  /// The Euclidean centre to conformal coordinates of the centre, moved along the geodesic where the radius is cut off.
  [[nodiscard]] Vector<double, m> conformal_centre(const Vector<double, m>& sphere_centre) const;

  Curvature curvature_;
  double most_tangent_;
  /// So far out that a ball through the point and one of them is cut off; they close the cell.
  std::vector<Vector<double, m>> fence_;
};

}  // namespace delcert
