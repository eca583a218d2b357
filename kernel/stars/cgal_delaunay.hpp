#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <utility>

#include "kernel/stars/growing_delaunay.hpp"

namespace delcert {

/// A Delaunay triangulation of CGAL of dimension m = 2 or 3, `Cgal`, whose vertices know their indices.
template <int m, class Cgal>
class CgalDelaunay {
 public:
  void add(const std::vector<Vector<double, m>>& points) {
    std::vector<std::pair<typename Cgal::Point, std::uint32_t>> input;
    input.reserve(points.size());
    for (const auto& point : points)
      input.emplace_back(std::apply([](auto... x) { return typename Cgal::Point(x...); }, point), size_++);
    of_all_.insert(input.begin(), input.end());
  }

  /// All, with their vertices sorted, the simplices too.
  [[nodiscard]] std::vector<IndexSimplex<m>> sorted_simplices() const {
    auto result = simplices();
    for (IndexSimplex<m>& simplex : result) std::sort(simplex.begin(), simplex.end());
    std::sort(result.begin(), result.end());
    return result;
  }
  /// In no particular order of them or of their vertices.
  [[nodiscard]] std::vector<IndexSimplex<m>> simplices() const {
    std::vector<IndexSimplex<m>> result;
    if (of_all_.dimension() < m) return result;
    for (const auto handle : handles()) {
      IndexSimplex<m> simplex;
      for (int corner = 0; corner <= m; ++corner)
        simplex[static_cast<std::size_t>(corner)] = handle->vertex(corner)->info();
      result.push_back(simplex);
    }
    return result;
  }

 private:
  auto handles() const {
    if constexpr (m == 2) {
      return of_all_.finite_face_handles();
    } else {
      return of_all_.finite_cell_handles();
    }
  }

  Cgal of_all_;
  std::uint32_t size_ = 0;
};

}  // namespace delcert
