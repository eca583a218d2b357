#include "kernel/manifold/submanifold/mesh_neighbours.hpp"

#include <map>

#include "support/error.hpp"

namespace delcert {

namespace {

std::string facet_text(const TriangleMesh& mesh, std::uint32_t facet) {
  const auto& [a, b, c] = mesh.triangles[facet];
  return "facet " + std::to_string(facet) + " (vertices " + std::to_string(a) + " " + std::to_string(b) + " " +
         std::to_string(c) + ")";
}

bool has_area(const TriangleMesh& mesh, std::uint32_t facet) {
  std::array<std::vector<Rational>, 2> edges;
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      edges[k].push_back(mesh.points[mesh.triangles[facet][k + 1]][axis] - mesh.points[mesh.triangles[facet][0]][axis]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3;
    if (edges[0][axis] * edges[1][next] != edges[0][next] * edges[1][axis]) return true;
  }
  return false;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> neighbours_if_closed(const std::string& name, const TriangleMesh& mesh) {
  const auto refuse = [&](const std::string& reason) { throw Rejection(name + ": " + reason); };
  struct Side {
    std::uint32_t facet;
    std::size_t edge;
    bool is_forward;
  };
  std::map<std::array<std::uint32_t, 2>, std::vector<Side>> sides;
  for (std::uint32_t facet = 0; facet < mesh.triangles.size(); ++facet) {
    if (!has_area(mesh, facet))
      refuse(facet_text(mesh, facet) + " has no area: collapse one of its edges, or flip the longest");
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const std::uint32_t from = mesh.triangles[facet][edge];
      const std::uint32_t to = mesh.triangles[facet][(edge + 1) % 3];
      sides[{std::min(from, to), std::max(from, to)}].push_back({facet, edge, from < to});
    }
  }
  std::vector<std::array<std::uint32_t, 3>> result(mesh.triangles.size());
  for (const auto& [ends, facets] : sides) {
    const std::string edge = "the edge of vertices " + std::to_string(ends[0]) + " and " + std::to_string(ends[1]);
    if (facets.size() == 1) {
      refuse(edge + " is in " + facet_text(mesh, facets[0].facet) +
             " only: close the boundary, or, if it is a crack, merge the vertices along it");
    }
    if (facets.size() > 2)
      refuse(edge + " is in " + std::to_string(facets.size()) +
             " facets, where there should be two: " + facet_text(mesh, facets[0].facet) + ", " +
             facet_text(mesh, facets[1].facet) + ", " + facet_text(mesh, facets[2].facet));
    if (facets[0].is_forward == facets[1].is_forward)
      refuse(edge + " has the same direction in " + facet_text(mesh, facets[0].facet) + " and " +
             facet_text(mesh, facets[1].facet) + ": reverse one of them, so that all facets show the same side");
    result[facets[0].facet].at(facets[0].edge) = facets[1].facet;
    result[facets[1].facet].at(facets[1].edge) = facets[0].facet;
  }
  return result;
}

}  // namespace delcert
