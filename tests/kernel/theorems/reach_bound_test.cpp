#include "kernel/theorems/reach_bound.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "kernel/number/middle.hpp"
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
    density = approximate_double(graph_density<2>(vertices, triangles, triangulation, atlas.slope()).density);
  }
  [[nodiscard]] ReachBound bound(double greatest_length) const { return bound(greatest_length, density); }
  [[nodiscard]] ReachBound bound(double greatest_length, double with_density) const {
    return bound_reach<2>(zero_set, vertices, triangles, std::vector<double>(atlas.size(), with_density), atlas.slope(),
                          greatest_length, no_progress());
  }
};

/// Of radius 1/2, with a gap of 1/10.
const Surface& near_spheres() {
  static const Surface surface(
      zero_set("near-spheres", {"x", "y", "z"}, {"((x + 11/20)^2 + y^2 + z^2 - 1/4)*((x - 11/20)^2 + y^2 + z^2 - 1/4)"},
               {ratio(5, 4), ratio(3, 4), ratio(3, 4)}),
      ratio(1, 40));
  return surface;
}

/// An upper bound of the reach, from all pairs of vertices: H. Federer, Curvature measures, Trans. AMS 93 (1959),
/// Theorem 4.18 says that it is the infimum of |y − x|²/(2 dist(y − x, T_x)). In doubles, with a derivative of f for
/// the normal.
double reach_by_pairs(const Surface& surface) {
  using Place = std::array<double, 3>;
  std::vector<Place> places, normals;
  FormulaEvaluation<double> f(surface.zero_set.map());
  for (std::uint32_t i = 0; i < surface.atlas.size(); ++i) {
    Place x{}, normal{};
    double value = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = middle_of(surface.vertices.position(i)[axis]);
    EXPECT_TRUE(f.first(x.data(), &value, normal.data()));
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (double& entry : normal) entry /= length;
    places.push_back(x);
    normals.push_back(normal);
  }
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (const Place& y : places) {
      double squared = 0, above = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double step = y[axis] - places[i][axis];
        squared += step * step;
        above += step * normals[i][axis];
      }
      if (2 * std::fabs(above) * result > squared) result = squared / (2 * std::fabs(above));
    }
  }
  return result;
}

/// What is said is allowed by all pairs of points; so many times as much is not.
void expect_allowed(const ReachBound& found, const Surface& surface, double too_much) {
  const double most = reach_by_pairs(surface);
  EXPECT_LE(found.reach, most);
  // The twin.
  EXPECT_GT(too_much * found.reach, most);
}

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
  expect_allowed(found, sphere, 1.6);
  // With so coarse a density neighbourhoods meet whose points no curve shorter than π/κ is known to join.
  EXPECT_EQ(sphere.bound(3, 0.35).bottleneck, 0);
  // Segments that are not looked at may be normal.
  expect_reach(sphere.bound(0.5), 0.25, 1.01);
}

TEST(ReachBound, of_a_torus) {
  const Surface torus(torus_of_revolution(), ratio(1, 12));
  const ReachBound found = torus.bound(1.5);
  expect_reach(found, 1, 2.5);
  expect_allowed(found, torus, 2.6);
}

TEST(ReachBound, of_an_ellipsoid_is_that_of_its_greatest_curvature) {
  const Surface ellipsoid(
      zero_set("ellipsoid", {"x", "y", "z"}, {"x^2/4 + 4*y^2/9 + z^2 - 1"}, {Rational(3), Rational(2), ratio(3, 2)}),
      ratio(1, 16));
  const ReachBound found = ellipsoid.bound(1);
  EXPECT_GE(found.curvature, 2);
  expect_reach(found, 0.5, 2);
  expect_allowed(found, ellipsoid, 2.6);
}

TEST(ReachBound, of_two_spheres_that_are_near_each_other_is_half_the_gap) {
  const Surface& spheres = near_spheres();
  const ReachBound found = spheres.bound(1);
  EXPECT_LE(found.bottleneck, 0.1);
  expect_reach(found, 0.05, 4);
  expect_allowed(found, spheres, 5);
}

/// The twin of the comparison with pairs of points: what curvature alone would allow is too much between two sheets.
TEST(ReachBound, by_curvature_alone_is_more_than_pairs_of_points_allow) {
  const Surface& spheres = near_spheres();
  ReachBound wrong = spheres.bound(1);
  wrong.reach = 1 / wrong.curvature;
  const double most = reach_by_pairs(spheres);
  EXPECT_LE(most, 0.06);
  EXPECT_GT(wrong.reach, 2 * most);
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
