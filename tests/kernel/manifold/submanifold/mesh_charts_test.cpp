#include <gtest/gtest.h>

#include "kernel/manifold/submanifold/chart_fitting.hpp"
#include "kernel/manifold/submanifold/cover_check.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "support/error.hpp"
#include "tests/kernel/manifold/submanifold/mesh_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Centres = std::vector<std::vector<Rational>>;

std::string refusal(const TriangleMesh& mesh, const Centres& centres, const Rational& radius) {
  const PolyhedralMesh m("m", mesh, {});
  return message_of<Rejection>([&] { (void)m.fit_charts(centres, radius, no_progress()); });
}

TEST(MeshCharts, of_a_sphere_fit_and_cover_it) {
  const PolyhedralMesh mesh = polyhedral_sphere(12);
  const auto net = submanifold_net<2>(mesh, ratio(1, 8), 1, no_progress());
  EXPECT_GT(net.centres.size(), 450U);
  EXPECT_LT(net.centres.size(), 1000U);
  EXPECT_GE(net.charts.patch_factor, 3);
  // A cap of the sphere is as steep as this at its rim, and a facet is a little steeper.
  const double rim = approximate_double(net.charts.patch_factor) / 8;
  EXPECT_GE(approximate_double(net.charts.slope), rim / std::sqrt(1 - rim * rim) * 0.9);
  EXPECT_LE(net.charts.slope, Rational(1));
  EXPECT_TRUE(mesh.check_cover(net.charts.charts, no_progress()).open.empty());

  // Without the charts about one place.
  std::vector<TangentChart> some;
  for (const TangentChart& chart : net.charts.charts) {
    if (chart.data().centre[2] < ratio(1, 4)) some.push_back(chart);
  }
  const CoverReport hole = mesh.check_cover(some, no_progress());
  EXPECT_FALSE(hole.open.empty());
  for (const BoxPart& part : hole.open) EXPECT_GT(part.upper[2], 0.25);
}

TEST(MeshCharts, that_are_too_steep_name_the_facets) {
  // A cube, each face divided in two: its edges are creases at every radius.
  TriangleMesh cube;
  for (int corner = 0; corner < 8; ++corner)
    cube.points.push_back({Rational(corner & 1), Rational((corner & 2) / 2), Rational((corner & 4) / 4)});
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const std::string text =
      refusal(cube, {{ratio(1, 2), ratio(1, 3), Rational(0)}, {Rational(0), ratio(1, 3), ratio(1, 60)}}, ratio(1, 20));
  EXPECT_NE(text.find("facet "), std::string::npos) << text;
  EXPECT_NE(text.find("smooth the mesh"), std::string::npos) << text;
  // Inside of a face there is nothing to refuse.
  EXPECT_EQ(refusal(cube, {{ratio(1, 2), ratio(1, 3), Rational(0)}}, ratio(1, 20)), "accepted");
}

TEST(MeshCharts, with_another_sheet_in_them_are_refused) {
  // Two spheres that overlap: each is closed, and the union meets itself.
  TriangleMesh two = sphere_mesh(6);
  const TriangleMesh one = two;
  for (const auto& point : one.points) two.points.push_back({point[0] + ratio(3, 2), point[1], point[2]});
  for (auto triangle : one.triangles) {
    for (std::uint32_t& vertex : triangle) vertex += static_cast<std::uint32_t>(one.points.size());
    two.triangles.push_back(triangle);
  }
  const auto net = [&](const TriangleMesh& mesh) {
    const PolyhedralMesh m("m", mesh, {});
    return message_of<Rejection>([&] { (void)submanifold_net<2>(m, ratio(1, 8), 1, no_progress()); });
  };
  const std::string text = net(two);
  EXPECT_TRUE(text.find("another part of the mesh") != std::string::npos || text.find("steeper") != std::string::npos)
      << text;
  // Apart they pass.
  for (std::size_t k = one.points.size(); k < two.points.size(); ++k) two.points[k][0] = two.points[k][0] + Rational(2);
  EXPECT_EQ(net(two), "accepted");
}

TEST(MeshCharts, over_which_facets_lie_twice_are_refused) {
  // The same sphere twice, with vertices of their own.
  TriangleMesh two = sphere_mesh(4);
  const TriangleMesh one = two;
  for (const auto& point : one.points) two.points.push_back(point);
  for (auto triangle : one.triangles) {
    for (std::uint32_t& vertex : triangle) vertex += static_cast<std::uint32_t>(one.points.size());
    two.triangles.push_back(triangle);
  }
  const std::string text = refusal(two, {{Rational(0), Rational(0), Rational(1)}}, ratio(1, 10));
  EXPECT_NE(text.find("another part of the mesh"), std::string::npos) << text;
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
