#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>

#include "kernel/stars/approximate_delaunay.hpp"

namespace delcert {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using CellBase = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Structure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
}  // namespace

template <>
std::vector<IndexSimplex<3>> approximate_delaunay<3>(const std::vector<Vector<double, 3>>& points) {
  std::vector<std::pair<Kernel::Point_3, std::uint32_t>> input;
  input.reserve(points.size());
  for (const auto& point : points) input.emplace_back(Kernel::Point_3(point[0], point[1], point[2]), input.size());
  const Triangulation triangulation(input.begin(), input.end());
  std::vector<IndexSimplex<3>> result;
  if (triangulation.dimension() < 3) return result;
  result.reserve(triangulation.number_of_finite_cells());
  for (const auto cell : triangulation.finite_cell_handles()) {
    IndexSimplex<3> simplex;
    for (int corner = 0; corner < 4; ++corner) simplex[static_cast<std::size_t>(corner)] = cell->vertex(corner)->info();
    std::sort(simplex.begin(), simplex.end());
    result.push_back(simplex);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace delcert
