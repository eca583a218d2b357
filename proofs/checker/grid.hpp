#pragma once

#include <vector>

#include "proofs/checker/failure.hpp"
#include "proofs/checker/point_set.hpp"

namespace delcert::checker {

/// Finds the lifts of a point set in a box of the frame, by cells. On a flat torus the cells divide [0, 1)^m, a point
/// is stored at its lift there, and the cells repeat with the lattice; on a Euclidean ball they divide the bounding
/// box.
class Grid {
 public:
  /// Throws Undecided if a coordinate is so large that its enclosure is wider than a small part of a cell.
  explicit Grid(const PointSet& points);

  /// Calls f(vertex) for all lifts at distance <= radius from the centre, and for some others. The order depends on
  /// the point set only. Throws Undecided if the ball meets more than 10^8 cells.
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
  std::vector<std::size_t> begin_;  // of the labels of each cell
  std::vector<Vertex> vertices_;
};

template <class F>
void Grid::visit(const Vector<Interval>& centre, double radius, const F& f) const {
  // A lift at distance <= radius has |y_k - centre_k| <= radius stretch(k). The constructor puts the cell coordinate t
  // of a stored lift into a cell c with c - 2^-10 <= t <= c + 1 + 2^-10; the margin is more than that.
  constexpr double margin = 0x1p-8;
  struct Step {
    std::size_t cell;
    std::int32_t lift;
  };
  std::array<std::vector<Step>, 4> steps;
  double number = 1;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double reach = radius * points_->metric().stretch(k);
    const Interval box = scaled(k, centre[k] + Interval::between(-reach, reach));
    const double lower = std::floor(box.lower() - margin), upper = std::floor(box.upper() + margin);
    if (!(number * (upper - lower + 1) < 1e8 && lower > -0x1p30 && upper < 0x1p30))
      throw Undecided("a ball meets too many cells");
    number *= upper - lower + 1;
    for (auto c = static_cast<std::int64_t>(lower); c <= static_cast<std::int64_t>(upper); ++c) {
      const std::int64_t turns = (c >= 0 ? c : c - cells_[k] + 1) / cells_[k];
      if (turns != 0 && !points_->periodic()) continue;
      steps[k].push_back({static_cast<std::size_t>(c - turns * cells_[k]), static_cast<std::int32_t>(turns)});
    }
    if (steps[k].empty()) return;
  }
  for (std::size_t k = dimension_; k < 4; ++k) steps[k].push_back({0, 0});
  const auto stride = [this](std::size_t k) { return static_cast<std::size_t>(cells_[k]); };
  for (const Step& s3 : steps[3]) {
    for (const Step& s2 : steps[2]) {
      for (const Step& s1 : steps[1]) {
        const std::size_t row = ((s3.cell * stride(2) + s2.cell) * stride(1) + s1.cell) * stride(0);
        for (const Step& s0 : steps[0]) {
          for (std::size_t v = begin_[row + s0.cell]; v < begin_[row + s0.cell + 1]; ++v) {
            const Lift& stored = vertices_[v].lift;
            f(Vertex{vertices_[v].label,
                     {stored[0] + s0.lift, stored[1] + s1.lift, stored[2] + s2.lift, stored[3] + s3.lift}});
          }
        }
      }
    }
  }
}

}  // namespace delcert::checker
