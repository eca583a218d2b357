#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "kernel/stars/approximate_delaunay.hpp"

namespace delcert {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase>;
using PlaneTriangulation = CGAL::Delaunay_triangulation_2<Kernel, Structure>;

std::vector<std::pair<Kernel::Point_2, std::uint32_t>> with_indices(const std::vector<Vector<double, 2>>& points,
                                                                    std::uint32_t first) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> result;
  result.reserve(points.size());
  for (const auto& point : points) result.emplace_back(Kernel::Point_2(point[0], point[1]), first++);
  return result;
}

IndexSimplex<2> vertices_of(PlaneTriangulation::Face_handle face) {
  return {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
}
}  // namespace

template <>
std::vector<IndexSimplex<2>> approximate_delaunay<2>(const std::vector<Vector<double, 2>>& points) {
  const auto input = with_indices(points, 0);
  const PlaneTriangulation triangulation(input.begin(), input.end());
  std::vector<IndexSimplex<2>> result;
  result.reserve(triangulation.number_of_faces());
  for (const auto face : triangulation.finite_face_handles()) {
    IndexSimplex<2> simplex = vertices_of(face);
    std::sort(simplex.begin(), simplex.end());
    result.push_back(simplex);
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <>
struct GrowingDelaunay<2>::Triangulation {
  PlaneTriangulation of_all;
  std::uint32_t size = 0;
};

template <>
GrowingDelaunay<2>::GrowingDelaunay() : triangulation_(std::make_unique<Triangulation>()) {}

template <>
GrowingDelaunay<2>::~GrowingDelaunay() = default;

template <>
void GrowingDelaunay<2>::add(const std::vector<Vector<double, 2>>& points) {
  const auto input = with_indices(points, triangulation_->size);
  triangulation_->of_all.insert(input.begin(), input.end());
  triangulation_->size += static_cast<std::uint32_t>(points.size());
}

template <>
std::vector<IndexSimplex<2>> GrowingDelaunay<2>::simplices_at(const std::vector<unsigned char>& wanted) const {
  std::vector<IndexSimplex<2>> result;
  const PlaneTriangulation& triangulation = triangulation_->of_all;
  for (const auto face : triangulation.finite_face_handles()) {
    const IndexSimplex<2> simplex = vertices_of(face);
    if (has_vertex_in<2>(simplex, wanted)) result.push_back(simplex);
  }
  return result;
}

}  // namespace delcert
