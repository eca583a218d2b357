#include "kernel/theorems/graph_triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/parallel/threads.hpp"
#include "tests/kernel/theorems/torus_mesh.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
GraphTriangulation<m> report_of(const Mesh<m>& mesh) {
  return check_graph_triangulation<m>(mesh.vertices(), mesh.simplices, no_progress());
}

TEST(GraphTriangulation, of_a_grid_is_of_the_torus) {
  const Mesh<2> mesh = torus_mesh(36, 14);
  const auto report = report_of<2>(mesh);
  EXPECT_TRUE(report.triangulates());
  EXPECT_LE(report.contraction, Rational(1) / Rational(4));
  EXPECT_LE(report.displacement, Rational(1) / Rational(50));
}

TEST(GraphTriangulation, of_a_polygon_is_of_the_circle) {
  const auto report = report_of<1>(circle_mesh(10));
  EXPECT_TRUE(report.triangulates());
  EXPECT_LE(report.contraction, Rational(1) / Rational(10));
}

TEST(GraphTriangulation, of_a_mesh_that_is_given_is_of_the_torus) {
  // Its vertices are the centres of the charts, near the torus and not on it.
  const Mesh<2> mesh = torus_mesh(36, 14);
  const GraphVertices vertices = given_vertices(mesh.zero_set, mesh.charts);
  ASSERT_EQ(vertices.residuals.size(), mesh.points.size());
  const auto report = check_graph_triangulation<2>(vertices, mesh.simplices, no_progress());
  EXPECT_TRUE(report.triangulates());
  EXPECT_LE(*std::max_element(vertices.residuals.begin(), vertices.residuals.end()), 0x1p-22);
  EXPECT_GT(*std::max_element(vertices.residuals.begin(), vertices.residuals.end()), 0);
  // Farther away it is so no more.
  GraphVertices away = given_vertices(mesh.zero_set, mesh.charts);
  away.residuals.assign(away.residuals.size(), 8);
  EXPECT_FALSE(check_graph_triangulation<2>(away, mesh.simplices, no_progress()).triangulates());
}

TEST(GraphTriangulation, is_not_what_winds_around_twice) {
  // All that is asked of simplices holds; every place has two labels.
  const auto twice = report_of<1>(circle_mesh(10, 2));
  EXPECT_TRUE(twice.failures.empty());
  EXPECT_EQ(twice.unclear, (std::vector<Label>{Label(0)}));
  EXPECT_FALSE(twice.triangulates());
  const auto torus = report_of<2>(torus_mesh(16, 8, 2));
  EXPECT_TRUE(torus.failures.empty());
  EXPECT_EQ(torus.unclear, (std::vector<Label>{Label(0)}));
}

TEST(GraphTriangulation, asks_for_a_clear_label_in_every_component) {
  // The same polygon twice, apart from each other in the complex and not in the plane.
  Mesh<1> mesh = circle_mesh(10);
  const std::size_t count = mesh.points.size();
  for (std::size_t k = 0; k < count; ++k) {
    mesh.points.push_back(mesh.points[k]);
    mesh.charts.push_back(mesh.charts[k]);
    const auto [v, w] = mesh.simplices[k];
    mesh.simplices.push_back({v + static_cast<std::uint32_t>(count), w + static_cast<std::uint32_t>(count)});
  }
  EXPECT_EQ(report_of<1>(mesh).unclear, (std::vector<Label>{Label(0), Label(static_cast<std::uint32_t>(count))}));
}

TEST(GraphTriangulation, names_the_simplices_that_fail) {
  Mesh<2> mesh = torus_mesh(20, 8);
  // A vertex that is pushed along the torus onto a neighbour: two simplices are degenerate, others too large.
  const std::uint32_t pushed = 100;
  mesh.points[pushed] = mesh.points[pushed + 1];
  const auto report = report_of<2>(mesh);
  EXPECT_EQ(std::count_if(report.failures.begin(), report.failures.end(),
                          [](const auto& failure) { return failure.cause == GraphCause::degenerate; }),
            2);
  for (const auto& failure : report.failures)
    EXPECT_TRUE(std::find(failure.simplex.begin(), failure.simplex.end(), pushed) != failure.simplex.end());
  EXPECT_FALSE(report.triangulates());
}

TEST(GraphTriangulation, does_not_depend_on_threads) {
  const Mesh<2> mesh = torus_mesh(16, 8);
  const auto all = report_of<2>(mesh);
  const ThreadLimit limit(1);
  const auto one = report_of<2>(mesh);
  EXPECT_EQ(all.contraction, one.contraction);
  EXPECT_EQ(all.displacement, one.displacement);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
