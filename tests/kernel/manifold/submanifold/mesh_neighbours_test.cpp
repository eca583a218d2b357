#include "kernel/manifold/submanifold/mesh_neighbours.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/kernel/manifold/submanifold/mesh_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::string refusal(const TriangleMesh& mesh) {
  return message_of<Rejection>([&] { (void)neighbours_if_closed("m", mesh); });
}

TEST(MeshNeighbours, of_what_is_not_closed_are_refused_with_what_to_do) {
  const TriangleMesh whole = sphere_mesh(2);
  TriangleMesh open = whole;
  open.triangles.pop_back();
  EXPECT_NE(refusal(open).find("close the boundary"), std::string::npos);

  // One vertex of one facet is another one, a unit in the last place away.
  TriangleMesh cracked = whole;
  const std::uint32_t vertex = cracked.triangles[5][0];
  cracked.points.push_back(cracked.points[vertex]);
  cracked.points.back()[0] = cracked.points.back()[0] + Rational::power_of_two(-53);
  cracked.triangles[5][0] = static_cast<std::uint32_t>(cracked.points.size() - 1);
  EXPECT_NE(refusal(cracked).find("merge the vertices"), std::string::npos);

  TriangleMesh twice = whole;
  twice.triangles.push_back(twice.triangles[3]);
  EXPECT_NE(refusal(twice).find("where there should be two"), std::string::npos);

  TriangleMesh reversed = whole;
  std::swap(reversed.triangles[7][0], reversed.triangles[7][1]);
  EXPECT_NE(refusal(reversed).find("reverse one of them"), std::string::npos);
  EXPECT_NE(refusal(reversed).find("facet 7 "), std::string::npos);

  TriangleMesh flat = whole;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    flat.points[flat.triangles[9][2]][axis] =
        (flat.points[flat.triangles[9][0]][axis] + flat.points[flat.triangles[9][1]][axis]) / Rational(2);
  }
  EXPECT_NE(refusal(flat).find("facet 9 "), std::string::npos);
  EXPECT_NE(refusal(flat).find("no area"), std::string::npos);
  EXPECT_EQ(refusal(whole), "accepted");
}

TEST(MeshNeighbours, share_the_edge_that_they_are_listed_for) {
  const TriangleMesh mesh = sphere_mesh(2);
  const auto neighbours = neighbours_if_closed("m", mesh);
  for (std::size_t facet = 0; facet < mesh.triangles.size(); ++facet) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const auto& there = mesh.triangles[neighbours[facet].at(edge)];
      for (const std::size_t end : {edge, (edge + 1) % 3})
        EXPECT_NE(std::find(there.begin(), there.end(), mesh.triangles[facet].at(end)), there.end());
      EXPECT_NE(neighbours[facet].at(edge), facet);
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
