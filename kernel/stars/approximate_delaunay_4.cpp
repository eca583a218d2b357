#include <CGAL/Delaunay_triangulation.h>
#include <CGAL/Epick_d.h>

#include <algorithm>

#include "kernel/stars/growing_delaunay.hpp"

namespace delcert {

namespace {
using Kernel = CGAL::Epick_d<CGAL::Dimension_tag<4>>;
using Structure =
    CGAL::Triangulation_data_structure<Kernel::Dimension, CGAL::Triangulation_vertex<Kernel, std::uint32_t>,
                                       CGAL::Triangulation_full_cell<Kernel>>;
using Triangulation = CGAL::Delaunay_triangulation<Kernel, Structure>;
}  // namespace

template <>
std::vector<IndexSimplex<4>> approximate_delaunay<4>(const std::vector<Vector<double, 4>>& points) {
  Triangulation triangulation(4);
  Triangulation::Full_cell_handle hint;
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    const Triangulation::Point point(4, points[index].begin(), points[index].end());
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert(point, hint);
    hint = vertex->full_cell();
    if (triangulation.number_of_vertices() > before) vertex->data() = index;
  }
  std::vector<IndexSimplex<4>> result;
  if (triangulation.current_dimension() < 4) return result;
  for (auto cell = triangulation.finite_full_cells_begin(); cell != triangulation.finite_full_cells_end(); ++cell) {
    IndexSimplex<4> simplex;
    for (int corner = 0; corner < 5; ++corner) simplex[static_cast<std::size_t>(corner)] = cell->vertex(corner)->data();
    std::sort(simplex.begin(), simplex.end());
    result.push_back(simplex);
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <>
struct GrowingDelaunay<4>::Triangulation : RemadeDelaunay<4> {};
template class GrowingDelaunay<4>;

}  // namespace delcert
