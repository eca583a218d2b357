#pragma once

#include <memory>

#include "proofs/checker/core/rules.hpp"

namespace delcert::checker_tests::by_hand {

/// Data for the core that are made by hand; what they refer to lives as long.
struct CoreSample {
  checker::core::Data data;
  std::shared_ptr<checker::NumberField> field;  // none: rational
  /// Coordinates that are not yet on the space: for K = 1 the point is x / |x|, for K = -1 (sqrt(1 + |y|^2), y) with
  /// y = x_1 ... x_m, for K = 0 x itself.
  std::vector<std::array<checker::Rational, 4>> coordinates;

  std::size_t m() const { return data.m; }
  /// The positions of the points, from the coordinates. To be called when they have changed.
  void place_points();
  /// A loop for every generator, as short as possible; none where there is none.
  void find_loops();
  /// Adds the simplex with these labels, increasing, and the numbers of their elements, of which the first is 0.
  void add(const std::vector<checker::Label>& labels, const std::vector<std::uint32_t>& elements);
  void remove(std::size_t simplex);
};

/// The torus of sides^m boxes, each cut into m! simplices, in the lattice A_m^*: regular and strictly Delaunay. The
/// generators are the unit vectors times `unit`; coordinates are those of R^m / (extent Z^m).
CoreSample grid_torus(std::size_t m, int sides);
/// That of 2 sides x sides squares, the double cover, with the generators of the torus that it covers.
CoreSample covering_torus(int sides);

/// The regular convex polytope with these vertices, whose edges are the shortest distances; modulo x -> -x.
CoreSample polytope(std::size_t m, const std::vector<std::array<double, 4>>& vertices, bool up_to_sign);
CoreSample icosahedron(bool up_to_sign);
CoreSample cross_polytope(std::size_t m);
CoreSample cell_600(bool up_to_sign);

/// Random points, as many as fit, and their Delaunay triangles, found in doubles by brute force.
CoreSample klein_bottle();
CoreSample bolza_surface();

/// By how much the point nearest to a circumball is outside of it, in doubles, among all lifts near the triangles. Of
/// klein_bottle().
double least_protection(const CoreSample& sample);

/// The rules that reject the data, among core.* and 4.*: group, manifold, quotient, hinges.
std::vector<std::string> broken_rules(const CoreSample& sample);
/// The same if these margins of level 4 are claimed.
std::vector<std::string> broken_rules(const CoreSample& sample, const std::string& circumradius,
                                      const std::string& protection);

}  // namespace delcert::checker_tests::by_hand
