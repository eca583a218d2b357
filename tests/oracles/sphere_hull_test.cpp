// The sphere: the Delaunay complex of points of 𝕊ᵐ is the boundary of their convex hull. CGAL's triangulation on the
// sphere and its convex hulls in ℝ⁴ against the certified complex.

#include <CGAL/Delaunay_triangulation_on_sphere_2.h>
#include <CGAL/Delaunay_triangulation_on_sphere_traits_2.h>
#include <CGAL/Epick_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation.h>

#include <map>

#include "tests/oracles/space_form_sample.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

// Both take the doubles nearest to the points, and decide exactly about those.

LabelComplex<2> cgal_complex_on_sphere(const SpaceFormSample<2>& sample) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Traits = CGAL::Delaunay_triangulation_on_sphere_traits_2<Kernel>;
  using Triangulation = CGAL::Delaunay_triangulation_on_sphere_2<Traits>;
  Triangulation triangulation(Traits(CGAL::ORIGIN, 1));
  std::map<Triangulation::Vertex_handle, std::uint32_t> label_of;
  for (std::uint32_t label = 0; label < sample.atlas.size(); ++label) {
    const auto x = model_position<2>(sample, Label(label));
    const Kernel::Point_3 point(approximate_double(x[0]), approximate_double(x[1]), approximate_double(x[2]));
    label_of[triangulation.insert(point)] = label;
  }
  EXPECT_EQ(triangulation.number_of_vertices(), sample.atlas.size());
  EXPECT_EQ(label_of.size(), sample.atlas.size());
  EXPECT_EQ(triangulation.number_of_ghost_faces(), 0U);
  LabelComplex<2> result;
  for (auto face = triangulation.solid_faces_begin(); face != triangulation.solid_faces_end(); ++face) {
    result.push_back({label_of.at(face->vertex(0)), label_of.at(face->vertex(1)), label_of.at(face->vertex(2))});
  }
  sort_simplices<2>(result);
  return result;
}

/// The facets of the hull in ℝ⁴: the infinite cells of a triangulation of it.
LabelComplex<3> cgal_hull(const SpaceFormSample<3>& sample) {
  using Kernel = CGAL::Epick_d<CGAL::Dimension_tag<4>>;
  using Vertex = CGAL::Triangulation_vertex<Kernel, std::uint32_t>;
  using Structure =
      CGAL::Triangulation_data_structure<CGAL::Dimension_tag<4>, Vertex, CGAL::Triangulation_full_cell<Kernel>>;
  CGAL::Triangulation<Kernel, Structure> triangulation(4);
  CGAL::Triangulation<Kernel, Structure>::Full_cell_handle near;
  for (std::uint32_t label = 0; label < sample.atlas.size(); ++label) {
    const auto x = model_position<3>(sample, Label(label));
    const auto vertex = triangulation.insert(Kernel::Point_d(approximate_double(x[0]), approximate_double(x[1]),
                                                             approximate_double(x[2]), approximate_double(x[3])),
                                             near);
    vertex->data() = label;
    near = vertex->full_cell();
  }
  EXPECT_EQ(triangulation.number_of_vertices(), sample.atlas.size());
  LabelComplex<3> result;
  for (auto cell = triangulation.full_cells_begin(); cell != triangulation.full_cells_end(); ++cell) {
    if (!triangulation.is_infinite(cell)) continue;
    LabelSimplex<3> simplex{};
    std::size_t next = 0;
    for (int corner = 0; corner <= 4; ++corner) {
      if (!triangulation.is_infinite(cell->vertex(corner))) simplex.at(next++) = cell->vertex(corner)->data();
    }
    result.push_back(simplex);
  }
  sort_simplices<3>(result);
  return result;
}

TEST(SphereHull, of_sphere_2_at_1_10_is_the_complex) {
  const auto sample = certified_sample<2>("sphere-2", Rational(Integer(1), Integer(10)));
  expect_same_labels<2>(sample.run.complex.simplices(), cgal_complex_on_sphere(sample));
}

TEST(SphereHull, of_sphere_2_at_1_5_is_the_complex_though_patches_are_small) {
  const auto sample = certified_sample<2>("sphere-2", Rational(Integer(1), Integer(5)));
  EXPECT_EQ(geometry_of(sample.atlas).patch_factor, 7);
  expect_same_labels<2>(sample.run.complex.simplices(), cgal_complex_on_sphere(sample));
}

TEST(SphereHull, of_sphere_3_at_1_5_is_the_complex) {
  const auto sample = certified_sample<3>("sphere-3", Rational(Integer(1), Integer(5)));
  expect_same_labels<3>(sample.run.complex.simplices(), cgal_hull(sample));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
