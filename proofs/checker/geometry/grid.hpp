#pragma once

#include <vector>

#include "proofs/checker/geometry/point_set.hpp"
#include "proofs/checker/report/budget.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

/// Finds the lifts of a point set near a point, by cells. On a flat torus the cells divide [0, 1)^m, a point is stored
/// at its lift there, and the cells repeat with the lattice; on a Euclidean ball they divide the bounding box.
class Grid {
 public:
  /// Throws Undecided if a coordinate is so large that its enclosure is not a small part of a cell.
  explicit Grid(const PointSet& points);

  /// Calls f(vertex) for all lifts at distance <= radius from the centre, and for some others, in an order that depends
  /// on the arguments only. Throws Undecided if the ball meets more than 10^7 cells.
  template <class F>
  void visit(const Vector<Interval>& centre, double radius, const F& f) const;

 private:
  /// The cell coordinate of the frame coordinate x along axis k.
  Interval scaled(std::size_t k, const Interval& x) const {
    return (x - Interval::between(origin_[k], origin_[k])) * Interval::between(scale_[k], scale_[k]);
  }

  const PointSet* points_;
  std::size_t dimension_;
  std::array<double, 4> origin_{}, scale_{};
  std::array<std::int64_t, 4> cells_{1, 1, 1, 1};
  std::vector<std::size_t> begin_;  // of the vertices of each cell
  std::vector<Vertex> vertices_;
};

template <class F>
void Grid::visit(const Vector<Interval>& centre, double radius, const F& f) const {
  // A lift at distance <= radius has |y_k - centre_k| <= radius stretch(k). The constructor puts the cell coordinate t
  // of a stored lift into a cell c with c - 2^-10 <= t <= c + 1 + 2^-10; the margin is more than that.
  constexpr double margin = 0x1p-8;
  // Cells that follow each other along the first axis stand together.
  struct Step {
    std::size_t cell, end;
    std::int32_t lift;
  };
  std::array<std::vector<Step>, 4> steps;
  double number = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    const double reach = k < dimension_ ? radius * points_->metric().stretch(k) : 0;
    const Interval box = scaled(k, centre[k] + Interval::between(-reach, reach));
    const double first = std::floor(box.lower() - margin), last = std::floor(box.upper() + margin);
    number *= last - first + 1;
    if (!(number <= 1e7 && first > -0x1p30 && last < 0x1p30)) throw Undecided("a ball meets too many cells");
    steps[k].reserve(static_cast<std::size_t>(last - first) + 1);
    for (auto c = static_cast<std::int64_t>(first); c <= static_cast<std::int64_t>(last); ++c) {
      const std::int64_t turns = (c >= 0 ? c : c - cells_[k] + 1) / cells_[k];
      if (turns != 0 && !(points_->periodic() && k < dimension_)) continue;
      const auto cell = static_cast<std::size_t>(c - turns * cells_[k]);
      if (k == 0 && !steps[0].empty() && steps[0].back().end == cell) {
        ++steps[0].back().end;
      } else {
        steps[k].push_back({cell, cell + 1, static_cast<std::int32_t>(turns)});
      }
    }
  }
  const auto size = [this](std::size_t k) { return static_cast<std::size_t>(cells_[k]); };
  for (const Step& s3 : steps[3]) {
    for (const Step& s2 : steps[2]) {
      for (const Step& s1 : steps[1]) {
        const std::size_t row = ((s3.cell * size(2) + s2.cell) * size(1) + s1.cell) * size(0);
        for (const Step& s0 : steps[0]) {
          const std::size_t begin = begin_[row + s0.cell], end = begin_[row + s0.end];
          Budget::spend(s0.end - s0.cell + (end - begin));
          for (std::size_t v = begin; v < end; ++v) {
            const Lift& at = vertices_[v].lift;
            f(Vertex{vertices_[v].label, {at[0] + s0.lift, at[1] + s1.lift, at[2] + s2.lift, at[3] + s3.lift}});
          }
        }
      }
    }
  }
}

}  // namespace delcert::checker
