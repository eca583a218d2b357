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
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Structure>;
}  // namespace

template <>
std::vector<IndexSimplex<2>> approximate_delaunay<2>(const std::vector<Vector<double, 2>>& points) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> input;
  input.reserve(points.size());
  for (const auto& point : points) input.emplace_back(Kernel::Point_2(point[0], point[1]), input.size());
  const Triangulation triangulation(input.begin(), input.end());
  std::vector<IndexSimplex<2>> result;
  result.reserve(triangulation.number_of_faces());
  for (const auto face : triangulation.finite_face_handles()) {
    IndexSimplex<2> simplex{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::sort(simplex.begin(), simplex.end());
    result.push_back(simplex);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace delcert
