#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "kernel/simplex/vector.hpp"

namespace delcert {

template <int m>
using IndexSimplex = std::array<std::uint32_t, static_cast<std::size_t>(m) + 1>;

/// The m-simplices of a Delaunay triangulation of these points of ℝᵐ (Cartesian coordinates), by CGAL with exact
/// predicates on the doubles as given; without error bounds as far as the points that the doubles stand for are
/// concerned, so only ever a proposal. Vertices in each simplex are sorted, the simplices too. Of points that
/// coincide only one is used. Points in a hyperplane have no simplices.
/// Precondition: rounding to nearest (no `RoundingGuard`).
template <int m>
[[nodiscard]] std::vector<IndexSimplex<m>> approximate_delaunay(const std::vector<Vector<double, m>>& points);

/// The same of points that become more: a round of new ones costs little more than these do.
template <int m>
class GrowingDelaunay {
 public:
  GrowingDelaunay();
  ~GrowingDelaunay();
  GrowingDelaunay(const GrowingDelaunay&) = delete;
  GrowingDelaunay& operator=(const GrowingDelaunay&) = delete;

  /// Their indices follow those of the points before.
  void add(const std::vector<Vector<double, m>>& points);
  /// In no particular order of simplices or of their vertices.
  [[nodiscard]] std::vector<IndexSimplex<m>> simplices() const;

 private:
  struct Triangulation;
  std::unique_ptr<Triangulation> triangulation_;
};

template <>
std::vector<IndexSimplex<1>> approximate_delaunay<1>(const std::vector<Vector<double, 1>>& points);
template <>
std::vector<IndexSimplex<2>> approximate_delaunay<2>(const std::vector<Vector<double, 2>>& points);
template <>
std::vector<IndexSimplex<3>> approximate_delaunay<3>(const std::vector<Vector<double, 3>>& points);
template <>
std::vector<IndexSimplex<4>> approximate_delaunay<4>(const std::vector<Vector<double, 4>>& points);
extern template class GrowingDelaunay<1>;
extern template class GrowingDelaunay<2>;
extern template class GrowingDelaunay<3>;
extern template class GrowingDelaunay<4>;

}  // namespace delcert
