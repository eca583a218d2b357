#include "proofs/checker/atlases/gluing_cells.hpp"

#include <algorithm>

#include "proofs/checker/geometry/near_points.hpp"

namespace delcert::checker {
namespace {

std::vector<Polynomial> appended(std::vector<Polynomial> a, const std::vector<Polynomial>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
std::vector<Polynomial> parts_of(const RationalMap& map, Polynomial RationalFunction::*part) {
  std::vector<Polynomial> result;
  for (const RationalFunction& f : map) result.push_back(f.*part);
  return result;
}

std::vector<Polynomial> sum_of_squares(const RationalMap& map, const Sides& box) {
  const std::size_t m = map.size();
  RationalFunction sum(Polynomial(m, Rational(0)));
  for (std::size_t k = 0; k < m; ++k) {
    const Rational half = (box[k][1].exact - box[k][0].exact) / Rational(2), centre = box[k][0].exact + half;
    const RationalFunction beyond(map[k].numerator - Polynomial(m, centre) * map[k].denominator,
                                  Polynomial(m, half) * map[k].denominator);
    const Polynomial above = beyond.numerator * beyond.numerator, below = beyond.denominator * beyond.denominator;
    sum = RationalFunction(sum.numerator * below + above * sum.denominator, sum.denominator * below);
  }
  return {sum.numerator, sum.denominator};
}

Verdict does_not_vanish(const Interval& x) {
  return x.lower() > 0 || x.upper() < 0 ? Verdict::proved : Verdict::undecided;
}
Interval absolute(const Interval& x) { return maximum(x, -x); }
/// Whether |a| >= factor |b|.
bool is_as_large(const Interval& a, const Interval& factor, const Interval& b) {
  return less_equal(factor * absolute(b), absolute(a)) == Verdict::proved;
}
bool is_known(const Interval& x) { return x.lower() > -0x1p500 && x.upper() < 0x1p500; }
Interval common(const Interval& a, const Interval& b) {
  return Interval::between(std::max(a.lower(), b.lower()), std::min(a.upper(), b.upper()));
}

}  // namespace

Passage::Passage(std::size_t m, std::size_t from_chart, std::size_t to_chart, const Sides& target, MapPiece piece,
                 std::vector<Polynomial> above_zero, std::vector<Polynomial> not_zero,
                 std::optional<FormulaMap> formulas)
    : from(from_chart),
      to(to_chart),
      box(&target),
      map(std::move(piece.map)),
      region(std::move(piece.nonnegative)),
      positive(std::move(above_zero)),
      nonzero(std::move(not_zero)),
      written(std::move(formulas)),
      borders(formulas_of(m, region)),
      conditions(formulas_of(m, positive)),
      polynomials(
          formulas_of(m, appended(appended(appended(positive, nonzero), parts_of(map, &RationalFunction::numerator)),
                                  parts_of(map, &RationalFunction::denominator)))),
      squares(formulas_of(m, sum_of_squares(map, target))) {}

PassageValues::PassageValues(const Passage& passage)
    : passage_(passage), borders_(passage.borders), polynomials_(passage.polynomials), squares_(passage.squares) {
  if (passage.written) written_ = std::make_unique<FormulaValues<Interval>>(*passage.written);
}

OnCell PassageValues::on(const Cell& cell) {
  const std::size_t m = passage_.map.size();
  OnCell result;
  if (!passage_.region.empty()) {
    const Cell borders = enclosed_values(borders_, cell);
    for (std::size_t k = 0; k < borders.size(); ++k)
      result.here = conjunction(result.here, less_equal(Interval(0), borders[k]));
  }
  const Cell values = enclosed_values(polynomials_, cell);
  std::size_t at = 0;
  for (std::size_t k = 0; k < passage_.positive.size(); ++k)
    result.positive = conjunction(result.positive, less(Interval(0), values[at++]));
  result.excluded = result.positive == Verdict::refuted || result.here == Verdict::refuted;
  Verdict regular = result.positive;
  for (std::size_t k = 0; k < passage_.nonzero.size(); ++k)
    regular = conjunction(regular, does_not_vanish(values[at++]));
  result.image = result.numerators = result.denominators = Cell(m, 1);
  result.has_image = true;
  for (std::size_t k = 0; k < m; ++k) {
    const Interval &above = result.numerators[k] = values[at + k], &below = result.denominators[k] = values[at + m + k];
    regular = conjunction(regular, does_not_vanish(below));
    result.has_image = result.has_image && does_not_vanish(below) == Verdict::proved;
    result.image[k] = above / below;
    const Quantity &from = (*passage_.box)[k][0], &to = (*passage_.box)[k][1];
    const Rational half = (to.exact - from.exact) / Rational(2);
    const Interval centre = enclosure(from.exact + half);
    result.excluded = result.excluded || is_as_large(above - centre * below, enclosure(half), below);
  }
  if (result.has_image && written_) {
    const Cell more = enclosed_values(*written_, cell);
    for (std::size_t k = 0; k < m; ++k) result.image[k] = common(result.image[k], more[k]);
  }
  for (std::size_t k = 0; k < m; ++k) result.has_image = result.has_image && is_known(result.image[k]);
  result.regular = regular == Verdict::proved && result.has_image;
  if (!result.excluded && !result.regular) {
    const Cell sums = enclosed_values(squares_, cell);
    result.excluded = is_as_large(sums[0], Interval(static_cast<int>(m)), sums[1]);
  }
  result.excluded = result.excluded || (result.has_image && is_outside(result.image, *passage_.box));
  return result;
}

Matrix<Interval> PassageValues::jacobian(const Cell& cell) {
  const std::size_t m = passage_.map.size();
  written_->evaluate(middle_of(cell), 1);
  Matrix<Interval> result = written_->jacobian();
  written_->evaluate(cell, 2);
  const Matrix<Interval> plain = written_->jacobian();
  const Cell offset = cell - middle_of(cell);
  for (std::size_t f = 0; f < m; ++f) {
    for (std::size_t k = 0; k < m; ++k) {
      for (std::size_t l = 0; l < m; ++l) result(f, k) = result(f, k) + written_->second(f, k, l) * offset[l];
      result(f, k) = common(result(f, k), plain(f, k));
    }
  }
  return result;
}

Cell middle_of(const Cell& cell) {
  Cell result = cell;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const double middle = std::clamp(NearPoints::middle(cell[k]), cell[k].lower(), cell[k].upper());
    result[k] = Interval::between(middle, middle);
  }
  return result;
}

Cell enclosed_values(FormulaValues<Interval>& functions, const Cell& cell) {
  const Cell middle = middle_of(cell);
  functions.evaluate(cell, 1);
  Cell result = functions.value();
  const Matrix<Interval> slopes = functions.jacobian();
  functions.evaluate(middle, 0);
  const Cell centred = functions.value() + slopes * (cell - middle);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = common(result[k], centred[k]);
  return result;
}

Cell cell_of(const Sides& sides) {
  Cell result(sides.size(), 1);
  for (std::size_t k = 0; k < sides.size(); ++k)
    result[k] = Interval::between(sides[k][0].filter.lower(), sides[k][1].filter.upper());
  return result;
}

bool is_inside_open(const Cell& cell, const Sides& box) {
  Verdict result = Verdict::proved;
  for (std::size_t k = 0; k < box.size(); ++k)
    result = conjunction(result, conjunction(less(box[k][0].filter, cell[k]), less(cell[k], box[k][1].filter)));
  return result == Verdict::proved;
}
bool is_inside_closed(const Cell& cell, const Sides& box) {
  Verdict result = Verdict::proved;
  for (std::size_t k = 0; k < box.size(); ++k)
    result =
        conjunction(result, conjunction(less_equal(box[k][0].filter, cell[k]), less_equal(cell[k], box[k][1].filter)));
  return result == Verdict::proved;
}
bool is_outside(const Cell& cell, const Sides& box) {
  Verdict result = Verdict::refuted;
  for (std::size_t k = 0; k < box.size(); ++k)
    result = disjunction(result, disjunction(less(cell[k], box[k][0].filter), less(box[k][1].filter, cell[k])));
  return result == Verdict::proved;
}

std::array<Cell, 2> halves(const Cell& cell, std::size_t axis) {
  std::array<Cell, 2> result{cell, cell};
  const double middle = middle_of(cell)[axis].upper();
  result[0][axis] = Interval::between(cell[axis].lower(), middle);
  result[1][axis] = Interval::between(middle, cell[axis].upper());
  return result;
}

Division divided(const Cell& whole, std::size_t most_halvings, bool all,
                 const std::function<CellState(const Cell&)>& state) {
  Division result;
  std::vector<std::pair<Cell, std::size_t>> waiting{{whole, 0}};
  while (!waiting.empty()) {
    const auto [cell, halvings] = std::move(waiting.back());
    waiting.pop_back();
    const CellState found = state(cell);
    if (found == CellState::settled) continue;
    if (found == CellState::broken) return {true, {cell}};
    if (halvings == most_halvings * whole.size()) {
      result.left.push_back(cell);
      if (!all) return result;
      continue;
    }
    for (Cell& half : halves(cell, halvings % whole.size())) waiting.emplace_back(std::move(half), halvings + 1);
  }
  return result;
}

namespace {

/// Whether the one map and then the other is the identity; none if it is nowhere defined.
std::optional<bool> is_undone(const std::vector<MapPiece>& first, const std::vector<MapPiece>& second, std::size_t m) {
  bool result = true;
  for (const MapPiece& one : first) {
    for (const MapPiece& other : second) {
      const auto both = composed_pieces(one, other);
      if (!both) return std::nullopt;
      if (may_be_positive_together(both->nonnegative)) result = result && both->map == identity_map(m);
    }
  }
  return result;
}

/// The denominators of one map after the other, unless they are numbers.
std::vector<Polynomial> denominators_after(const std::vector<MapPiece>& second, const MapPiece& first, std::size_t m) {
  std::vector<Polynomial> result;
  for (const MapPiece& piece : second) {
    const auto after = composed(formulas_of(m, parts_of(piece.map, &RationalFunction::denominator)), first.map);
    for (const RationalFunction& f : *after) {
      if (f.numerator.is_zero() || !f.numerator.is_constant()) result.push_back(f.numerator);
    }
  }
  return result;
}

/// As the file has it, or, of one piece of several, which is affine, its polynomials.
FormulaMap formulas_of_piece(const MapPiece& piece, const FormulaMap& whole, std::size_t m) {
  return is_rational(whole) ? whole : formulas_of(m, piece.map);
}

}  // namespace

std::vector<Passage> passages_of(const Gluing& gluing, const std::function<void(std::size_t)>& not_inverse) {
  const std::size_t m = gluing.m;
  std::vector<Passage> result;
  for (std::size_t t = 0; t < gluing.transitions.size(); ++t) {
    const Gluing::Transition& transition = gluing.transitions[t];
    const auto map = pieces_of(m, transition.map), inverse = pieces_of(m, transition.inverse);
    const auto where = composed(transition.where, identity_map(m));
    if (!where) throw Malformed("form.formula", "transition " + std::to_string(t) + " divides by 0 everywhere");
    const auto there_and_back = is_undone(map, inverse, m), back_and_there = is_undone(inverse, map, m);
    if (!there_and_back || !back_and_there) {
      not_inverse(t);
      throw Undecided("the map of transition " + std::to_string(t) + " has no inverse");
    }
    if (!*there_and_back || !*back_and_there) not_inverse(t);
    std::vector<Polynomial> here;
    for (const RationalFunction& condition : *where) {
      if (!condition.denominator.is_constant())
        throw Malformed("form.formula", "a condition of transition " + std::to_string(t) + " is no polynomial");
      here.push_back(condition.numerator);
    }
    const auto &from = transition.from, &to = transition.to;
    for (const MapPiece& piece : map) {
      result.emplace_back(m, from, to, gluing.charts[to].domain, piece, here, denominators_after(inverse, piece, m),
                          formulas_of_piece(piece, transition.map, m));
      result.back().number = 2 * t;
    }
    for (const MapPiece& piece : inverse) {
      result.emplace_back(m, to, from, gluing.charts[from].domain, piece, signs_after(here, piece.map),
                          denominators_after(map, piece, m), formulas_of_piece(piece, transition.inverse, m));
      result.back().number = 2 * t + 1;
    }
  }
  return result;
}

std::vector<std::vector<std::size_t>> by_number(const std::vector<Passage>& passages) {
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t at = 0; at < passages.size(); ++at) {
    result.resize(std::max(result.size(), passages[at].number + 1));
    result[passages[at].number].push_back(at);
  }
  return result;
}

}  // namespace delcert::checker
