#include "kernel/theorems/reach_bound.hpp"

#include <gtest/gtest.h>

#include "kernel/parallel/threads.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "kernel/theorems/restricted_delaunay.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// A surface with a net, its complex and r̂.
struct Surface {
  ZeroSet zero_set;
  Rational radius;
  SubmanifoldAtlas<2> atlas{zero_set, submanifold_net<2>(zero_set, radius, 1, no_progress()).charts, radius,
                            no_progress()};
  GraphVertices vertices{atlas.manifold(), atlas.charts(), {}, {}};
  std::vector<LabelSimplex<2>> triangles;
  double density = 0;

  Surface(ZeroSet of, Rational sampling_radius) : zero_set(std::move(of)), radius(std::move(sampling_radius)) {
    RunRequest request;
    request.certify_model = false;
    const auto run =
        run_in_charts<2>(atlas, geometry_of<2>(atlas), measured_parameters(Dimension(2), 1), request, no_progress());
    triangles = run.complex.simplices();
    vertices.positions = graph_vertices<2>(atlas, run.points).positions;
    const auto triangulation = check_graph_triangulation<2>(vertices, triangles, no_progress());
    EXPECT_TRUE(triangulation.triangulates());
    density = approximate_double(graph_density<2>(vertices, triangles, triangulation, atlas.slope()));
  }
  [[nodiscard]] ReachBound bound(double greatest_length) const {
    return bound_reach<2>(zero_set, vertices, triangles, std::vector<double>(atlas.size(), density), atlas.slope(),
                          greatest_length, no_progress());
  }
};

/// The bound is one, and within a factor of the reach.
void expect_reach(const ReachBound& found, double reach, double factor) {
  EXPECT_LE(found.reach, reach);
  EXPECT_GE(found.reach * factor, reach);
}

TEST(ReachBound, of_a_sphere) {
  const Surface sphere(unit_sphere_in_space(), ratio(1, 10));
  const ReachBound found = sphere.bound(3);
  EXPECT_GE(found.curvature, 1);
  EXPECT_LE(found.curvature, 1.4);
  EXPECT_LE(found.bottleneck, 2);
  expect_reach(found, 1, 1.5);
  // Segments that are not looked at may be normal.
  expect_reach(sphere.bound(0.5), 0.25, 1.01);
}

TEST(ReachBound, of_a_torus) {
  const Surface torus(torus_of_revolution(), ratio(1, 12));
  expect_reach(torus.bound(1.5), 1, 2.5);
}

TEST(ReachBound, of_an_ellipsoid_is_that_of_its_greatest_curvature) {
  const Surface ellipsoid(
      zero_set("ellipsoid", {"x", "y", "z"}, {"x^2/4 + 4*y^2/9 + z^2 - 1"}, {Rational(3), Rational(2), ratio(3, 2)}),
      ratio(1, 16));
  const ReachBound found = ellipsoid.bound(1);
  EXPECT_GE(found.curvature, 2);
  expect_reach(found, 0.5, 2);
}

TEST(ReachBound, of_two_spheres_that_are_near_each_other_is_half_the_gap) {
  const Surface spheres(
      zero_set("near-spheres", {"x", "y", "z"}, {"((x + 11/20)^2 + y^2 + z^2 - 1/4)*((x - 11/20)^2 + y^2 + z^2 - 1/4)"},
               {ratio(5, 4), ratio(3, 4), ratio(3, 4)}),
      ratio(1, 40));
  const ReachBound found = spheres.bound(1);
  EXPECT_LE(found.bottleneck, 0.1);
  expect_reach(found, 0.05, 4);
}

TEST(ReachBound, does_not_depend_on_threads) {
  const Surface sphere(unit_sphere_in_space(), ratio(1, 8));
  const ReachBound all = sphere.bound(1);
  const ThreadLimit one(1);
  const ReachBound alone = sphere.bound(1);
  EXPECT_EQ(all.reach, alone.reach);
  EXPECT_EQ(all.curvature, alone.curvature);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
