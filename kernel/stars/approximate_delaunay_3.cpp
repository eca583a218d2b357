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
using SpaceTriangulation = CGAL::Delaunay_triangulation_3<Kernel, Structure>;

std::vector<std::pair<Kernel::Point_3, std::uint32_t>> with_indices(const std::vector<Vector<double, 3>>& points,
                                                                    std::uint32_t first) {
  std::vector<std::pair<Kernel::Point_3, std::uint32_t>> result;
  result.reserve(points.size());
  for (const auto& point : points) result.emplace_back(Kernel::Point_3(point[0], point[1], point[2]), first++);
  return result;
}

IndexSimplex<3> vertices_of(SpaceTriangulation::Cell_handle cell) {
  IndexSimplex<3> result;
  for (int corner = 0; corner < 4; ++corner) result[static_cast<std::size_t>(corner)] = cell->vertex(corner)->info();
  return result;
}
}  // namespace

template <>
std::vector<IndexSimplex<3>> approximate_delaunay<3>(const std::vector<Vector<double, 3>>& points) {
  const auto input = with_indices(points, 0);
  const SpaceTriangulation triangulation(input.begin(), input.end());
  std::vector<IndexSimplex<3>> result;
  if (triangulation.dimension() < 3) return result;
  result.reserve(triangulation.number_of_finite_cells());
  for (const auto cell : triangulation.finite_cell_handles()) {
    IndexSimplex<3> simplex = vertices_of(cell);
    std::sort(simplex.begin(), simplex.end());
    result.push_back(simplex);
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <>
struct GrowingDelaunay<3>::Triangulation {
  SpaceTriangulation of_all;
  std::uint32_t size = 0;
};

template <>
GrowingDelaunay<3>::GrowingDelaunay() : triangulation_(std::make_unique<Triangulation>()) {}

template <>
GrowingDelaunay<3>::~GrowingDelaunay() = default;

template <>
void GrowingDelaunay<3>::add(const std::vector<Vector<double, 3>>& points) {
  const auto input = with_indices(points, triangulation_->size);
  triangulation_->of_all.insert(input.begin(), input.end());
  triangulation_->size += static_cast<std::uint32_t>(points.size());
}

template <>
std::vector<IndexSimplex<3>> GrowingDelaunay<3>::simplices_at(const std::vector<unsigned char>& wanted) const {
  std::vector<IndexSimplex<3>> result;
  const SpaceTriangulation& triangulation = triangulation_->of_all;
  if (triangulation.dimension() < 3) return result;
  for (const auto cell : triangulation.finite_cell_handles()) {
    const IndexSimplex<3> simplex = vertices_of(cell);
    if (has_vertex_in<3>(simplex, wanted)) result.push_back(simplex);
  }
  return result;
}

}  // namespace delcert
