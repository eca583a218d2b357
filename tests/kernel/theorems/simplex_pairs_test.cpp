#include "kernel/theorems/simplex_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/theorems/graph_triangulation.hpp"
#include "tests/kernel/theorems/triangulated_mesh.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// A mesh, and what is asked of its pairs of simplices.
template <int m>
struct Measured : TriangulatedMesh<m> {
  using TriangulatedMesh<m>::mesh, TriangulatedMesh<m>::vertices, TriangulatedMesh<m>::triangulation;

  using TriangulatedMesh<m>::TriangulatedMesh;

  [[nodiscard]] std::vector<bool> all_labels() const { return std::vector<bool>(mesh.points.size(), true); }
  [[nodiscard]] SimplexPairs pairs(const std::vector<bool>& is_tight, double most = 1) const {
    return check_simplex_pairs<m>(vertices, mesh.simplices, triangulation.simplices, is_tight,
                                  approximate_double(triangulation.displacement), most, no_progress());
  }
  [[nodiscard]] SimplexPairs pairs() const { return pairs(all_labels()); }
};

const Measured<2>& torus() {
  static const Measured<2> result(torus_mesh(16, 8));
  return result;
}

double shortest_edge(const Mesh<1>& mesh) {
  double result = 1;
  for (const auto& [v, w] : mesh.simplices) {
    double squared = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double along = approximate_double(mesh.points[v][axis] - mesh.points[w][axis]);
      squared += along * along;
    }
    result = std::min(result, std::sqrt(squared));
  }
  return result;
}

TEST(SimplexPairs, of_a_polygon_are_nearly_as_far_apart_as_its_edges_are_long) {
  const Measured<1> circle(circle_mesh(10));
  const SimplexPairs pairs = circle.pairs();
  const double edge = shortest_edge(circle.mesh);
  EXPECT_LE(pairs.margin, edge);
  EXPECT_GE(pairs.margin, 0.95 * edge);
  EXPECT_TRUE(pairs.crowded.empty());
}

TEST(SimplexPairs, of_a_grid_on_the_torus_are_apart) {
  const SimplexPairs pairs = torus().pairs();
  EXPECT_GT(pairs.margin, 0);
  EXPECT_TRUE(pairs.crowded.empty());
}

TEST(SimplexPairs, are_those_of_simplices_with_tight_labels) {
  std::vector<bool> is_tight(torus().mesh.points.size());
  EXPECT_EQ(torus().pairs(is_tight, 0.25).margin, 0.25);
  is_tight[17] = true;
  const SimplexPairs pairs = torus().pairs(is_tight);
  EXPECT_GE(pairs.margin, torus().pairs().margin);
  EXPECT_LT(pairs.margin, 1);
}

TEST(SimplexPairs, of_what_winds_around_twice_meet) {
  // Every place has two edges, which have no label in common.
  const Measured<1> circle(circle_mesh(10, 2));
  ASSERT_TRUE(circle.triangulation.failures.empty());
  const SimplexPairs pairs = circle.pairs();
  EXPECT_LT(pairs.margin, 0);
  EXPECT_EQ(pairs.crowded.size(), circle.mesh.points.size());
  EXPECT_TRUE(
      std::is_sorted(pairs.crowded.begin(), pairs.crowded.end(), [](Label a, Label b) { return a.value < b.value; }));
}

TEST(SimplexPairs, may_meet_where_one_is_moved_far) {
  Measured<1> circle(circle_mesh(10));
  const LabelSimplex<1> far = circle.mesh.simplices[3];
  circle.triangulation.simplices[3].shift = 10;
  circle.triangulation.displacement = Rational(5);
  const SimplexPairs pairs = circle.pairs();
  EXPECT_LT(pairs.margin, 0);
  std::vector<bool> is_tight = circle.all_labels();
  for (const std::uint32_t label : far) {
    EXPECT_EQ(std::count(pairs.crowded.begin(), pairs.crowded.end(), Label(label)), 1);
    is_tight[label] = false;
  }
  // Nothing is asked of it if none of its labels is tight.
  EXPECT_GT(circle.pairs(is_tight).margin, 0);
}

TEST(SimplexPairs, with_a_common_label_ask_for_the_star_of_one_of_them) {
  const std::vector<LabelSimplex<2>>& simplices = torus().mesh.simplices;
  std::vector<GraphSimplex<2>> measures = torus().triangulation.simplices;
  const std::uint32_t narrow = simplices[100][0];
  for (std::size_t at = 0; at < simplices.size(); ++at) {
    for (std::size_t v = 0; v < 3; ++v) {
      if (simplices[at][v] == narrow) measures[at].rooms[v] = -0.125;
    }
  }
  std::vector<bool> is_tight(torus().mesh.points.size());
  is_tight[narrow] = true;
  // Simplices that have this label in common and nothing else; those with an edge in common have another label.
  const SimplexPairs pairs =
      check_simplex_pairs<2>(torus().vertices, simplices, measures, is_tight,
                             approximate_double(torus().triangulation.displacement), 1, no_progress());
  EXPECT_EQ(pairs.margin, -0.125);
  EXPECT_EQ(pairs.crowded, (std::vector<Label>{Label(narrow)}));
}

TEST(SimplexPairs, have_margins_in_units) {
  Measured<1> circle(circle_mesh(10));
  const double margin = circle.pairs().margin;
  circle.vertices.units.assign(circle.mesh.points.size(), 2);
  circle.triangulation.displacement = circle.triangulation.displacement / Rational(2);
  EXPECT_NEAR(circle.pairs().margin, margin / 2, 1e-12);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
