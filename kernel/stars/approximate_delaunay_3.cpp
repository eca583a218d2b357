#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "kernel/stars/cgal_delaunay.hpp"

namespace delcert {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using CellBase = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Structure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
using SpaceTriangulation = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
using OfPoints = CgalDelaunay<3, SpaceTriangulation>;
}  // namespace

template <>
std::vector<IndexSimplex<3>> approximate_delaunay<3>(const std::vector<Vector<double, 3>>& points) {
  OfPoints triangulation;
  triangulation.add(points);
  return triangulation.sorted_simplices();
}

template <>
struct GrowingDelaunay<3>::Triangulation : OfPoints {};
template class GrowingDelaunay<3>;

}  // namespace delcert
