#include "kernel/manifold/gluing/piecewise_values.hpp"

#include <algorithm>
#include <concepts>

#include "kernel/number/elementary.hpp"

namespace delcert {

namespace {

bool is_certainly_negative(double x) { return x < 0; }
bool is_certainly_negative(const Interval& x) { return x.upper() < 0; }
bool is_certainly_negative(const BigInterval& x) { return x.upper() < Rational(0); }

double joined(double, double b) { return b; }
Interval joined(const Interval& a, const Interval& b) {
  return Interval::between(std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper()));
}
BigInterval joined(const BigInterval& a, const BigInterval& b) { return hull(a, b); }

}  // namespace

template <class S>
PiecewiseValues<S>::PiecewiseValues(const std::vector<CellMap>& pieces)
    : pieces_(pieces), m_(pieces.front().dimension()), values_(m_), derivatives_(m_ * m_) {
  for (const CellMap& piece : pieces) {
    regions_.emplace_back(piece.region());
    formulas_.emplace_back(*piece.formulas());
  }
}

template <class S>
const std::vector<std::size_t>& PiecewiseValues<S>::pieces_at(const S* x) {
  met_.clear();
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
    conditions_.resize(pieces_[piece].nonnegative().size());
    // Polynomials are defined everywhere.
    if (!conditions_.empty()) (void)regions_[piece].value(x, conditions_.data());
    const bool is_elsewhere = std::any_of(conditions_.begin(), conditions_.end(),
                                          [](const S& condition) { return is_certainly_negative(condition); });
    if (!is_elsewhere) met_.push_back(piece);
    if (std::same_as<S, double> && !met_.empty()) break;
  }
  // Rounding may leave a double outside of all pieces.
  if (met_.empty()) met_.push_back(0);
  return met_;
}

template <class S>
template <class Evaluate>
bool PiecewiseValues<S>::of_all(const S* x, S* f, S* df, const Evaluate& evaluate) {
  bool is_first = true;
  for (const std::size_t piece : pieces_at(x)) {
    if (is_first) {
      if (!evaluate(piece, f, df)) return false;
      is_first = false;
      continue;
    }
    if (!evaluate(piece, values_.data(), derivatives_.data())) return false;
    for (std::size_t k = 0; k < m_; ++k) f[k] = joined(f[k], values_[k]);
    for (std::size_t k = 0; df != nullptr && k < m_ * m_; ++k) df[k] = joined(df[k], derivatives_[k]);
  }
  return true;
}

template <class S>
bool PiecewiseValues<S>::value(const S* x, S* f) {
  return of_all(x, f, nullptr, [&](std::size_t piece, S* value, S*) { return formulas_[piece].value(x, value); });
}

template <class S>
bool PiecewiseValues<S>::first(const S* x, S* f, S* df) {
  return of_all(x, f, df, [&](std::size_t piece, S* value, S* derivative) {
    return formulas_[piece].first(x, value, derivative);
  });
}

template class PiecewiseValues<double>;
template class PiecewiseValues<Interval>;
template class PiecewiseValues<BigInterval>;

bool centred_derivative(PiecewiseValues<Interval>& map, const Cell& cell, std::size_t m, Interval* df) {
  Cell middle;
  for (std::size_t axis = 0; axis < m; ++axis) {
    const double half_width = (cell[axis].upper() - cell[axis].lower()) / 2;
    middle[axis] = Interval::exactly(cell[axis].lower() + half_width);
  }
  std::array<Interval, 3> ignored;
  std::array<Interval, 9> at_middle;
  std::array<Interval, 9> derivative;
  std::array<Interval, 27> second;
  bool is_first = true;
  for (const std::size_t piece : map.pieces_at(cell.data())) {
    FormulaEvaluation<Interval>& formulas = map.formulas(piece);
    if (!formulas.second(cell.data(), ignored.data(), derivative.data(), second.data()) ||
        !formulas.first(middle.data(), ignored.data(), at_middle.data()))
      return false;
    for (std::size_t k = 0; k < m * m; ++k) {
      Interval centred = at_middle[k];
      for (std::size_t axis = 0; axis < m; ++axis) centred += second[k * m + axis] * (cell[axis] - middle[axis]);
      df[k] = is_first ? centred : joined(df[k], centred);
    }
    is_first = false;
  }
  return true;
}

}  // namespace delcert
