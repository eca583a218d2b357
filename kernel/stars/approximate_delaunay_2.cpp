#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "kernel/stars/cgal_delaunay.hpp"

namespace delcert {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase>;
using PlaneTriangulation = CGAL::Delaunay_triangulation_2<Kernel, Structure>;
using OfPoints = CgalDelaunay<2, PlaneTriangulation>;
}  // namespace

template <>
std::vector<IndexSimplex<2>> approximate_delaunay<2>(const std::vector<Vector<double, 2>>& points) {
  OfPoints triangulation;
  triangulation.add(points);
  return triangulation.sorted_simplices();
}

template <>
struct GrowingDelaunay<2>::Triangulation : OfPoints {};
template class GrowingDelaunay<2>;

}  // namespace delcert
