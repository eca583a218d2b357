// Surfaces in ℝ³: the restricted Delaunay complex is the set of facets of the Delaunay complex in space whose dual
// Voronoi edges meet the surface. CGAL's triangulation, exact on the doubles nearest to the points, against the stars
// in tangent charts. An edge that meets the surface an odd number of times has values of different signs at its ends;
// one that meets it twice would be overlooked, and the complexes would differ.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <map>
#include <optional>

#include "tests/kernel/manifold/submanifold/samples.hpp"
#include "tests/oracles/cgal_delaunay.hpp"
#include "tests/oracles/submanifold_sample.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using Triangulation = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<Vertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;

class Surface {
 public:
  explicit Surface(const ZeroSet& zero_set) : f_(zero_set.map()) {
    // A compact surface has one side that goes to infinity.
    for (const auto& [from, to] : zero_set.description().box) outside_.push_back(approximate_double(to));
  }
  [[nodiscard]] bool is_positive(const std::vector<double>& x) {
    double value = 0;
    EXPECT_TRUE(f_.value(x.data(), &value));
    return value > 0;
  }
  [[nodiscard]] bool is_positive_far_away() { return is_positive(outside_); }

 private:
  FormulaEvaluation<double> f_;
  std::vector<double> outside_;
};

Triangulation triangulation_in_space(const SubmanifoldSample<2>& sample) {
  std::vector<std::pair<Kernel::Point_3, std::uint32_t>> points;
  for (std::uint32_t label = 0; label < sample.size(); ++label) {
    const std::vector<double> x = sample.position(label);
    points.emplace_back(Kernel::Point_3(x[0], x[1], x[2]), label);
  }
  Triangulation triangulation(points.begin(), points.end());
  EXPECT_EQ(triangulation.number_of_vertices(), sample.size());
  return triangulation;
}

LabelSimplex<2> facet_opposite(const Triangulation::Cell_handle& cell, int corner) {
  return {cell->vertex((corner + 1) % 4)->info(), cell->vertex((corner + 2) % 4)->info(),
          cell->vertex((corner + 3) % 4)->info()};
}

LabelComplex<2> restricted_complex(const SubmanifoldSample<2>& sample) {
  const Triangulation triangulation = triangulation_in_space(sample);
  Surface surface(sample.zero_set);
  const auto side = [&](Triangulation::Cell_handle cell) {
    if (triangulation.is_infinite(cell)) return surface.is_positive_far_away();
    const Kernel::Point_3 centre = triangulation.dual(cell);
    return surface.is_positive({centre.x(), centre.y(), centre.z()});
  };
  LabelComplex<2> result;
  for (const auto& [cell, opposite] : triangulation.finite_facets()) {
    if (side(cell) == side(cell->neighbor(opposite))) continue;
    result.push_back(facet_opposite(cell, opposite));
  }
  sort_simplices<2>(result);
  return result;
}

TEST(RestrictedDelaunayInSpace, of_a_torus_are_the_stars_in_charts) {
  const SubmanifoldSample<2> sample("torus-of-revolution", ratio(1, 8));
  EXPECT_GT(sample.size(), 3000U);
  expect_same_labels<2>(sample.simplices, restricted_complex(sample));
}

TEST(RestrictedDelaunayInSpace, of_an_ellipsoid_are_the_stars_in_charts) {
  const SubmanifoldSample<2> sample("ellipsoid", ratio(1, 10));
  expect_same_labels<2>(sample.simplices, restricted_complex(sample));
}

TEST(RestrictedDelaunayInSpace, of_a_sphere_are_the_facets_of_the_hull) {
  const SubmanifoldSample<2> sample(unit_sphere_in_space(), ratio(1, 8));
  expect_same_labels<2>(sample.simplices, restricted_complex(sample));
  const Triangulation triangulation = triangulation_in_space(sample);
  LabelComplex<2> hull;
  for (const auto cell : triangulation.all_cell_handles()) {
    if (triangulation.is_infinite(cell))
      hull.push_back(facet_opposite(cell, cell->index(triangulation.infinite_vertex())));
  }
  sort_simplices<2>(hull);
  expect_same_labels<2>(sample.simplices, hull);
}

TEST(RestrictedDelaunayInSpace, of_two_spheres_are_the_stars_in_charts) {
  const SubmanifoldSample<2> sample("two-spheres", ratio(1, 17));
  expect_same_labels<2>(sample.simplices, restricted_complex(sample));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
