#include "tests/oracles/cgal_delaunay.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace delcert::test {

namespace {

using DoubleKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// CGAL's names in dimension m, and how its full-dimensional cells are listed.
template <int m>
struct Cgal;

template <>
struct Cgal<2> {
  using Traits = CGAL::Periodic_2_Delaunay_triangulation_traits_2<DoubleKernel>;
  using Periodic = CGAL::Periodic_2_Delaunay_triangulation_2<Traits>;
  using Point = DoubleKernel::Point_2;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Lift<2>, DoubleKernel>;
  using Plain = CGAL::Delaunay_triangulation_2<DoubleKernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

  static Point point(const Vector<double, 2>& x) { return {x[0], x[1]}; }
  static Vector<double, 2> coordinates(const Point& p) { return {p.x(), p.y()}; }
  static Shift<2> shift(const Periodic::Offset& offset) { return {offset.x(), offset.y()}; }
  static auto cells(const Periodic& t) { return CGAL::make_range(t.faces_begin(), t.faces_end()); }
  static auto cells(const Plain& t) { return CGAL::make_range(t.finite_faces_begin(), t.finite_faces_end()); }
};

template <>
struct Cgal<3> {
  using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<DoubleKernel>;
  using Periodic = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;
  using Point = DoubleKernel::Point_3;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<Lift<3>, DoubleKernel>;
  using Plain = CGAL::Delaunay_triangulation_3<DoubleKernel, CGAL::Triangulation_data_structure_3<VertexBase>>;

  static Point point(const Vector<double, 3>& x) { return {x[0], x[1], x[2]}; }
  static Vector<double, 3> coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }
  static Shift<3> shift(const Periodic::Offset& offset) { return {offset.x(), offset.y(), offset.z()}; }
  static auto cells(const Periodic& t) { return CGAL::make_range(t.cells_begin(), t.cells_end()); }
  static auto cells(const Plain& t) { return CGAL::make_range(t.finite_cells_begin(), t.finite_cells_end()); }
};

}  // namespace

template <int m>
struct CgalTorus<m>::Triangulation {
  using Names = Cgal<m>;

  explicit Triangulation(const Doubles<m>& points) {
    std::vector<typename Names::Point> reduced;
    for (std::uint32_t index = 0; index < points.size(); ++index) {
      Vector<double, m> x = points[index];
      Shift<m> moved{};
      for (std::size_t axis = 0; axis < m; ++axis) {
        double whole = std::floor(x[axis]);
        if (x[axis] - whole >= 1) ++whole;  // −2⁻⁶⁰ + 1 rounds to 1
        x[axis] -= whole;
        moved[axis] = static_cast<std::int32_t>(whole);
      }
      reduced.push_back(Names::point(x));
      floors.push_back(moved);
      index_of.emplace(reduced.back(), index);
    }
    periodic.insert(reduced.begin(), reduced.end(), true);
    EXPECT_TRUE(periodic.is_valid());
    EXPECT_EQ(periodic.number_of_vertices(), points.size());
    for (std::size_t axis = 0; axis < m; ++axis) {
      EXPECT_EQ(periodic.number_of_sheets()[axis], 1);
    }
  }

  /// Calls `visit` with the m + 1 pairs (point of the unit cell, vector that moves it) of each cell.
  template <class Visit>
  void for_each_cell(const Visit& visit) const {
    const auto cells = Names::cells(periodic);
    for (auto cell = cells.begin(); cell != cells.end(); ++cell) {
      std::array<std::pair<typename Names::Point, Shift<m>>, corner_count<m>> vertices;
      for (int corner = 0; corner <= m; ++corner) {
        const auto vertex = periodic.periodic_point(cell, corner);
        vertices[static_cast<std::size_t>(corner)] = {vertex.first, Names::shift(vertex.second)};
      }
      visit(vertices);
    }
  }

  typename Names::Periodic periodic;
  std::vector<Shift<m>> floors;  ///< by what each point was moved
  std::map<typename Names::Point, std::uint32_t> index_of;
};

template <int m>
CgalTorus<m>::CgalTorus(const Doubles<m>& points) : triangulation_(std::make_unique<Triangulation>(points)) {}
template <int m>
CgalTorus<m>::~CgalTorus() = default;

template <int m>
Complex<m> CgalTorus<m>::complex() const {
  Complex<m> result;
  triangulation_->for_each_cell([&](const auto& vertices) {
    LiftedSimplex<m> simplex;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      const std::uint32_t index = triangulation_->index_of.at(vertices[corner].first);
      simplex[corner] = {index, difference_of<m>(vertices[corner].second, triangulation_->floors[index])};
    }
    result.push_back(canonical<m>(simplex));
  });
  sort_and_unite<m>(result);
  return result;
}

template <int m>
std::vector<std::array<Corner<m>, corner_count<m>>> CgalTorus<m>::cells() const {
  std::vector<std::array<Corner<m>, corner_count<m>>> result;
  triangulation_->for_each_cell([&](const auto& vertices) {
    result.emplace_back();
    for (std::size_t corner = 0; corner <= m; ++corner) {
      result.back()[corner] = {Cgal<m>::coordinates(vertices[corner].first), vertices[corner].second};
    }
  });
  return result;
}

template <int m>
Complex<m> cgal_complex(const Doubles<m>& points, const std::vector<Lift<m>>& names,
                        const std::function<bool(const LiftedSimplex<m>&)>& keep) {
  using Names = Cgal<m>;
  std::vector<std::pair<typename Names::Point, Lift<m>>> named;
  for (std::size_t at = 0; at < points.size(); ++at) named.emplace_back(Names::point(points[at]), names[at]);
  typename Names::Plain triangulation;
  triangulation.insert(named.begin(), named.end());
  EXPECT_EQ(triangulation.number_of_vertices(), points.size());
  Complex<m> result;
  const auto cells = Names::cells(triangulation);
  for (auto cell = cells.begin(); cell != cells.end(); ++cell) {
    LiftedSimplex<m> simplex;
    for (int corner = 0; corner <= m; ++corner) {
      simplex[static_cast<std::size_t>(corner)] = cell->vertex(corner)->info();
    }
    if (keep(simplex)) result.push_back(canonical<m>(simplex));
  }
  sort_and_unite<m>(result);
  return result;
}

template class CgalTorus<2>;
template class CgalTorus<3>;
template Complex<2> cgal_complex<2>(const Doubles<2>&, const std::vector<Lift<2>>&,
                                    const std::function<bool(const LiftedSimplex<2>&)>&);
template Complex<3> cgal_complex<3>(const Doubles<3>&, const std::vector<Lift<3>>&,
                                    const std::function<bool(const LiftedSimplex<3>&)>&);

}  // namespace delcert::test
