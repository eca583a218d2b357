#pragma once

#include <vector>

#include "kernel/manifold/gluing/cell_map.hpp"

namespace delcert {

/// Encloses a map of several pieces on cells; only the pieces that may meet a cell count. Needs a `RoundingGuard`, in
/// the constructor too. Keeps references; has scratch memory.
class PiecewiseCells {
 public:
  explicit PiecewiseCells(const std::vector<CellMap>& pieces);

  /// Of all pieces: what is certain of each, and the hull of the images. Numerators and denominators are those of the
  /// last piece that may meet the cell.
  [[nodiscard]] MapOnCell on(const Cell& cell);
  [[nodiscard]] MapOnCell on(std::size_t piece, const Cell& cell) { return evaluations_[piece].on(cell); }
  /// Whether certainly no point of the one cell is taken to one of the other: den(x)·y = num(x) has no solution.
  [[nodiscard]] bool are_unrelated(const Cell& here, const Cell& there);

 private:
  std::size_t m_;
  std::vector<CellMapEvaluation> evaluations_;
};

}  // namespace delcert
