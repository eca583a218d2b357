#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "kernel/stars/proposal.hpp"

// Delaunay complexes by CGAL, exact on the doubles that it is given, in the form of ours: lifted labels, canonical,
// in increasing order. CGAL's templates take the compiler long, so only cgal_delaunay.cpp has them.
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

/// A point of the unit cell and the vector of ℤᵐ that moves it to a vertex of a cell.
template <int m>
using Corner = std::pair<Vector<double, m>, Shift<m>>;

/// CGAL's Delaunay triangulation of ℝᵐ/ℤᵐ (the square or the cube with opposite sides glued), m = 2 or 3.
template <int m>
class CgalTorus {
 public:
  /// Points outside the half-open unit cell are moved there; the complex speaks of the points as they are given.
  explicit CgalTorus(const Doubles<m>& points);
  CgalTorus(const CgalTorus&) = delete;
  CgalTorus& operator=(const CgalTorus&) = delete;
  ~CgalTorus();

  [[nodiscard]] Complex<m> complex() const;

  /// The m + 1 vertices of each cell.
  [[nodiscard]] std::vector<std::array<Corner<m>, corner_count<m>>> cells() const;

 private:
  struct Triangulation;
  std::unique_ptr<Triangulation> triangulation_;
};

/// CGAL's Delaunay triangulation of points of ℝᵐ, m = 2 or 3, each of which is named by a lift; cells that `keep` (a
/// predicate on the lifts of the vertices) rejects are left out.
template <int m>
Complex<m> cgal_complex(const Doubles<m>& points, const std::vector<Lift<m>>& names,
                        const std::function<bool(const LiftedSimplex<m>&)>& keep);

}  // namespace delcert::test
