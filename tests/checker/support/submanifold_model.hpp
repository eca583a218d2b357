#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/checker/support/certificate_text.hpp"

// Zero sets with points and simplices that are made without the program: certificates of them are right where their
// margins are.
namespace delcert::checker_tests {

/// A zero set, points near it, simplices of their labels. All numbers are doubles, which certificates state exactly.
struct SubmanifoldModel {
  std::size_t m = 2;
  std::vector<std::string> variables, equations;
  std::function<std::vector<double>(const std::vector<double>&)> map;  // what the equations say
  std::vector<std::pair<int, int>> box;
  bool given = false;  // whether the points are vertices that are given
  std::vector<std::vector<double>> points{};
  std::vector<std::vector<int>> simplices{};
  double sampling_radius = 0, patch_radius = 0, height = 0, slope = 0;
  double contraction = 0.5, displacement = 0, margin = 0;  // of levels 5 and 5i
  std::string metric = "extrinsic";                        // of level 4
  bool is_low = false;                                     // whether lids are lower than level 4 asks for
  double tilt = 0;                                         // of the first axis of charts, out of the tangent space
  std::vector<std::vector<double>> mesh{};                 // vertices, if the manifold is a mesh
  std::vector<std::vector<int>> facets{};
};

/// x^2 + y^2 + z^2 = 1 by an icosahedron whose triangles have been divided so often, and rescaled.
SubmanifoldModel sphere_model(int divisions);
/// The unit sphere in R^4 by the 600-cell, each of whose tetrahedra is cut into eight. The vertices are given.
SubmanifoldModel sphere_of_cells_model();
/// Two copies of a circle or a sphere, about 2 and -2 on the first axis; and the points of the first one alone.
SubmanifoldModel doubled(SubmanifoldModel model);
SubmanifoldModel first_component(SubmanifoldModel model);
/// A sphere that covers the sphere twice, with the poles as branch points: rings of points that go around twice. The
/// vertices are given.
SubmanifoldModel branched_sphere_model(int rings, int ring);
/// The torus of revolution with the radii 2 and 1, by `around` times `across` points; `turns` times around.
SubmanifoldModel torus_model(int around, int across, int turns);
/// x^2 + y^2 = 1, by a polygon that goes around so often.
SubmanifoldModel circle_model(int points, int turns);
/// Two circles with one centre, of radii 1 and 1 + gap, by polygons of so many points, half an edge ahead of each
/// other.
SubmanifoldModel nested_circles_model(int points, double gap);
/// The same points on the polyhedron of the other model's simplices, which is about the origin, instead of the zero
/// set. Facets show their outer sides.
SubmanifoldModel on_mesh(SubmanifoldModel model, const SubmanifoldModel& polyhedron);
/// The product of two such circles in R^4.
SubmanifoldModel flat_torus_model(int points);

/// The product of the unit circle and one of a quarter of its size, in charts that are so tilted that lengths along the
/// first circle look shorter than they are: stars are those of other edges than distances in space would choose.
SubmanifoldModel tilted_torus_model();

/// The graph over such a product of e = ac/2 and, in dimension 6, f = bd/2.
SubmanifoldModel lifted(SubmanifoldModel flat_torus, std::size_t dimension);

/// The document without its seal: the levels are those of the list that the certificate shall claim.
Json certificate(const SubmanifoldModel& model, const std::vector<std::string>& levels);

}  // namespace delcert::checker_tests
