#pragma once

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

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "kernel/stars/proposal.hpp"

// Delaunay complexes by CGAL, exact on the doubles that it is given, in the form of ours: lifted labels, canonical,
// in increasing order.
namespace delcert::test {

template <int m>
using Doubles = std::vector<Vector<double, m>>;
template <int m>
using Complex = std::vector<LiftedSimplex<m>>;
template <int m>
constexpr std::size_t corner_count = static_cast<std::size_t>(m) + 1;

template <int m>
void sort_and_unite(Complex<m>& simplices) {
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
}

/// The simplices that are in one of two complexes only, the first few of them by their labels; empty if there are none.
template <int m>
std::string disagreement(const Complex<m>& ours, const Complex<m>& theirs) {
  constexpr std::size_t most_shown = 5;
  Complex<m> different;
  std::set_symmetric_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(), std::back_inserter(different));
  if (different.empty()) return "";
  std::string result = std::to_string(different.size()) + " simplices of one complex only:";
  for (std::size_t at = 0; at < std::min(different.size(), most_shown); ++at) {
    for (const Lift<m>& lift : different[at]) result += " " + std::to_string(lift.index);
    result += std::binary_search(ours.begin(), ours.end(), different[at]) ? " (ours)" : " (theirs)";
  }
  return result;
}

namespace detail {

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
  static Shift<3> shift(const Periodic::Offset& offset) { return {offset.x(), offset.y(), offset.z()}; }
  static auto cells(const Periodic& t) { return CGAL::make_range(t.cells_begin(), t.cells_end()); }
  static auto cells(const Plain& t) { return CGAL::make_range(t.finite_cells_begin(), t.finite_cells_end()); }
};

}  // namespace detail

/// CGAL's Delaunay triangulation of ℝᵐ/ℤᵐ (the square or the cube with opposite sides glued).
template <int m>
class CgalTorus {
 public:
  using Cgal = detail::Cgal<m>;

  /// Points outside the half-open unit cell are moved there; `floors_` remembers by what.
  explicit CgalTorus(const Doubles<m>& points) {
    std::vector<typename Cgal::Point> reduced;
    for (std::uint32_t index = 0; index < points.size(); ++index) {
      Vector<double, m> x = points[index];
      Shift<m> moved{};
      for (std::size_t axis = 0; axis < m; ++axis) {
        double whole = std::floor(x[axis]);
        if (x[axis] - whole >= 1) ++whole;  // −2⁻⁶⁰ + 1 rounds to 1
        x[axis] -= whole;
        moved[axis] = static_cast<std::int32_t>(whole);
      }
      reduced.push_back(Cgal::point(x));
      floors_.push_back(moved);
      index_.emplace(reduced.back(), index);
    }
    triangulation_.insert(reduced.begin(), reduced.end(), true);
    EXPECT_TRUE(triangulation_.is_valid());
    EXPECT_EQ(triangulation_.number_of_vertices(), points.size());
    for (std::size_t axis = 0; axis < m; ++axis) {
      EXPECT_EQ(triangulation_.number_of_sheets()[axis], 1);
    }
  }

  [[nodiscard]] Complex<m> complex() const {
    Complex<m> result;
    for_each_cell([&](const auto& vertices) {
      LiftedSimplex<m> simplex;
      for (std::size_t corner = 0; corner <= m; ++corner) {
        const std::uint32_t index = index_.at(vertices[corner].first);
        simplex[corner] = {index, difference_of<m>(Cgal::shift(vertices[corner].second), floors_[index])};
      }
      result.push_back(canonical<m>(simplex));
    });
    sort_and_unite<m>(result);
    return result;
  }

  /// Calls `visit` with the m + 1 pairs (point of the unit cell, offset) of each cell.
  template <class Visit>
  void for_each_cell(const Visit& visit) const {
    const auto cells = Cgal::cells(triangulation_);
    for (auto cell = cells.begin(); cell != cells.end(); ++cell) {
      std::array<std::pair<typename Cgal::Point, typename Cgal::Periodic::Offset>, static_cast<std::size_t>(m) + 1>
          vertices;
      for (int corner = 0; corner <= m; ++corner) {
        const auto vertex = triangulation_.periodic_point(cell, corner);
        vertices[static_cast<std::size_t>(corner)] = {vertex.first, vertex.second};
      }
      visit(vertices);
    }
  }

 private:
  typename Cgal::Periodic triangulation_;
  std::vector<Shift<m>> floors_;
  std::map<typename Cgal::Point, std::uint32_t> index_;
};

/// CGAL's Delaunay triangulation of points of ℝᵐ, each of which is named by a lift; cells that `keep` (a predicate on
/// the lifts of the vertices) rejects are left out.
template <int m, class Keep>
Complex<m> cgal_complex(const Doubles<m>& points, const std::vector<Lift<m>>& names, const Keep& keep) {
  using Cgal = detail::Cgal<m>;
  std::vector<std::pair<typename Cgal::Point, Lift<m>>> named;
  for (std::size_t at = 0; at < points.size(); ++at) named.emplace_back(Cgal::point(points[at]), names[at]);
  typename Cgal::Plain triangulation;
  triangulation.insert(named.begin(), named.end());
  EXPECT_EQ(triangulation.number_of_vertices(), points.size());
  Complex<m> result;
  const auto cells = Cgal::cells(triangulation);
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

}  // namespace delcert::test
