#include "kernel/theorems/graph_isotopy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"
#include "kernel/parallel/threads.hpp"
#include "tests/kernel/theorems/triangulated_mesh.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// A mesh of which level 5 holds.
template <int m>
struct Triangulated : TriangulatedMesh<m> {
  using TriangulatedMesh<m>::mesh, TriangulatedMesh<m>::vertices, TriangulatedMesh<m>::triangulation;

  explicit Triangulated(Mesh<m> made) : TriangulatedMesh<m>(std::move(made)) {
    EXPECT_TRUE(triangulation.triangulates());
  }

  [[nodiscard]] GraphIsotopy isotopy() const { return isotopy_in(mesh.zero_set); }
  /// As if the manifold were another one with the same charts.
  [[nodiscard]] GraphIsotopy isotopy_in(const EmbeddedManifold& manifold) const {
    const GraphVertices other{manifold, mesh.charts, vertices.positions, {}};
    return check_graph_isotopy<m>(other, mesh.simplices, triangulation, no_progress());
  }
};

/// Long and narrow cells: points move as on long edges, and stars are as wide as short ones.
const Triangulated<2>& narrow_torus() {
  static const Triangulated<2> result(torus_mesh(14, 60));
  return result;
}

const GraphIsotopy& narrow_isotopy() {
  static const GraphIsotopy result = narrow_torus().isotopy();
  return result;
}

/// Of the angle between the normal of a triangle and the gradient of x ↦ its distance from the torus, at a vertex.
double cosine_at(const LabelSimplex<2>& simplex, std::uint32_t vertex) {
  std::array<std::array<double, 3>, 3> x;
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      x[v][axis] = approximate_double(narrow_torus().mesh.points[simplex[v]][axis]);
  }
  std::array<double, 3> normal{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3;
    const std::size_t b = (k + 2) % 3;
    normal[k] = (x[1][a] - x[0][a]) * (x[2][b] - x[0][b]) - (x[1][b] - x[0][b]) * (x[2][a] - x[0][a]);
  }
  const std::vector<Rational>& place = narrow_torus().mesh.points[vertex];
  const std::array<double, 3> y{approximate_double(place[0]), approximate_double(place[1]),
                                approximate_double(place[2])};
  const double flat = std::hypot(y[0], y[1]);
  const double across = normal[0] * y[0] * (1 - 2 / flat) + normal[1] * y[1] * (1 - 2 / flat) + normal[2] * y[2];
  return std::abs(across) / std::hypot(normal[0], normal[1], normal[2]);
}

TEST(GraphIsotopy, of_a_grid_has_a_margin) {
  const GraphIsotopy isotopy = Triangulated<2>(torus_mesh(36, 14)).isotopy();
  EXPECT_GT(isotopy.margin, 0);
  EXPECT_TRUE(isotopy.holds());
  EXPECT_FALSE(isotopy.cosine);
  EXPECT_TRUE(Triangulated<1>(circle_mesh(10)).isotopy().margin > 0);
}

TEST(GraphIsotopy, is_by_pairs_of_simplices_where_cylinders_are_low) {
  // Some labels are not roomy; what follows from other simplices being too far away does not depend on lids.
  Mesh<2> mesh = torus_mesh(36, 14);
  const double margin = Triangulated<2>(mesh).isotopy().margin;
  for (TangentChart& chart : mesh.charts) chart.set_size(Rational(1), Rational(1) / Rational(45));
  const GraphIsotopy isotopy = Triangulated<2>(mesh).isotopy();
  EXPECT_GT(isotopy.margin, 0);
  EXPECT_TRUE(isotopy.crowded.empty());
  EXPECT_LE(isotopy.margin, margin);
}

TEST(GraphIsotopy, is_by_pairs_where_stars_are_not_wide) {
  // At some labels a third of the altitude is less than what points are moved.
  EXPECT_GT(Triangulated<2>(torus_mesh(14, 30)).isotopy().margin, 0);
}

TEST(GraphIsotopy, is_by_normals_where_stars_are_narrow) {
  const GraphIsotopy& isotopy = narrow_isotopy();
  EXPECT_LE(isotopy.margin, 0);
  EXPECT_FALSE(isotopy.crowded.empty());
  EXPECT_TRUE(isotopy.holds());
  ASSERT_TRUE(isotopy.cosine);
  // Beside what it is at the vertices.
  double least = 1;
  for (const LabelSimplex<2>& simplex : narrow_torus().mesh.simplices) {
    for (const std::uint32_t v : simplex) least = std::min(least, cosine_at(simplex, v));
  }
  EXPECT_LE(*isotopy.cosine, least + 1e-12);
  EXPECT_GE(*isotopy.cosine, least - 0.125);
}

TEST(GraphIsotopy, is_not_known_where_a_simplex_is_steep_too) {
  GraphVertices lifted = narrow_torus().mesh.vertices();
  const auto isotopy = [&] {
    return check_graph_isotopy<2>(lifted, narrow_torus().mesh.simplices, narrow_torus().triangulation, no_progress());
  };
  // Along the normal by about an edge, and by so much that triangles there are nearly vertical.
  const auto lift = [&](double by) {
    const std::vector<Rational>& place = narrow_torus().mesh.points[17];
    const std::array<double, 3> x{approximate_double(place[0]), approximate_double(place[1]),
                                  approximate_double(place[2])};
    const double flat = std::hypot(x[0], x[1]);
    const std::array<double, 3> normal{x[0] * (1 - 2 / flat), x[1] * (1 - 2 / flat), x[2]};
    for (std::size_t axis = 0; axis < 3; ++axis)
      lifted.positions[17 * 3 + axis] = Interval::exactly(x[axis] + by * normal[axis]);
  };
  lift(0.02);
  const GraphIsotopy uneven = isotopy();
  ASSERT_TRUE(uneven.cosine);
  EXPECT_LT(*uneven.cosine, *narrow_isotopy().cosine);
  lift(5);
  const GraphIsotopy steep = isotopy();
  EXPECT_FALSE(steep.cosine);
  EXPECT_FALSE(steep.holds());
}

TEST(GraphIsotopy, is_by_normals_of_one_equation_only) {
  // Flow lines of a gradient are along the normals of one equation, and a polyhedron has none.
  TriangleMesh tetrahedron{{{Rational(0), Rational(0), Rational(0)},
                            {Rational(1), Rational(0), Rational(0)},
                            {Rational(0), Rational(1), Rational(0)},
                            {Rational(0), Rational(0), Rational(1)}},
                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  const PolyhedralMesh polyhedron("tetrahedron", tetrahedron, {});
  const GraphIsotopy isotopy = narrow_torus().isotopy_in(polyhedron);
  EXPECT_LE(isotopy.margin, 0);
  EXPECT_FALSE(isotopy.cosine);
  EXPECT_FALSE(isotopy.holds());
}

TEST(GraphIsotopy, does_not_depend_on_threads) {
  const GraphIsotopy& all = narrow_isotopy();
  const ThreadLimit limit(1);
  const GraphIsotopy one = narrow_torus().isotopy();
  EXPECT_EQ(all.margin, one.margin);
  EXPECT_EQ(all.tightest, one.tightest);
  EXPECT_EQ(all.crowded, one.crowded);
  EXPECT_EQ(all.cosine, one.cosine);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
