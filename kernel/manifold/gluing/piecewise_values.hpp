#pragma once

#include <vector>

#include "kernel/manifold/gluing/cell_map.hpp"

namespace delcert {

/// Values and derivatives of a map of several pieces at points or on boxes, as `FormulaEvaluation` has them. On
/// intervals: of all pieces that may be met, the hull; on doubles: of one of them. Has scratch memory. On Interval it
/// needs a `RoundingGuard`, in the constructor too.
template <class S>
class PiecewiseValues {
 public:
  /// Keeps a reference. Precondition: all pieces have formulas.
  explicit PiecewiseValues(const std::vector<CellMap>& pieces);

  /// The pieces that may be met, by their places.
  [[nodiscard]] const std::vector<std::size_t>& pieces_at(const S* x);
  [[nodiscard]] FormulaEvaluation<S>& formulas(std::size_t piece) { return formulas_[piece]; }

  // As `FormulaEvaluation`: false where a value is not certainly defined.
  [[nodiscard]] bool value(const S* x, S* f);
  [[nodiscard]] bool first(const S* x, S* f, S* df);

 private:
  /// Calls evaluate(piece, f, df) for the pieces that may be met and writes the hulls of what they have written.
  template <class Evaluate>
  [[nodiscard]] bool of_all(const S* x, S* f, S* df, const Evaluate& evaluate);

  const std::vector<CellMap>& pieces_;
  std::size_t m_;
  std::vector<FormulaEvaluation<S>> regions_;
  std::vector<FormulaEvaluation<S>> formulas_;
  std::vector<S> conditions_;
  std::vector<std::size_t> met_;
  std::vector<S> values_;
  std::vector<S> derivatives_;
};

extern template class PiecewiseValues<double>;
extern template class PiecewiseValues<Interval>;
extern template class PiecewiseValues<BigInterval>;

/// Of the derivatives of all pieces that may be met on the cell, the hull, row by row: from the middle, by the mean
/// value theorem, which is tighter than what intervals make of the derivative. False where it is not certainly defined.
/// Needs a `RoundingGuard`.
[[nodiscard]] bool centred_derivative(PiecewiseValues<Interval>& map, const Cell& cell, std::size_t m, Interval* df);

}  // namespace delcert
