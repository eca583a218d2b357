#include "kernel/manifold/gluing/cell_map.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernel/formula/formula_error.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

namespace {

/// A double of the interval, about its middle.
double middle_of(const Interval& x) { return std::clamp(x.lower() / 2 + x.upper() / 2, x.lower(), x.upper()); }

Interval common_part(const Interval& a, const Interval& b) {
  return Interval::between(std::max(a.lower(), b.lower()), std::min(a.upper(), b.upper()));
}

bool vanishes_nowhere(const Interval& x) { return x.lower() > 0 || x.upper() < 0; }

/// Whether |a| ≥ factor·|b|.
bool is_as_large(const Interval& a, const Interval& factor, const Interval& b) {
  return absolute(a).lower() >= (factor * absolute(b)).upper();
}

/// Σ ((f_k − c_k)/h_k)² for the centre and the half-widths of the box.
RationalFunction sum_of_squares(const std::vector<RationalFunction>& map, const Sides& box) {
  const RingPointer& ring = map.front().numerator.ring();
  const Polynomial one(ring, Rational(1));
  std::optional<RationalFunction> result;
  for (std::size_t axis = 0; axis < map.size(); ++axis) {
    const Rational half_width = (box[axis][1] - box[axis][0]) / Rational(2);
    const RationalFunction centre{Polynomial(ring, box[axis][0] + half_width), one};
    const RationalFunction beyond =
        (map[axis] - centre) * RationalFunction{Polynomial(ring, Rational(1) / half_width), one};
    const RationalFunction squared = beyond * beyond;
    result = result ? *result + squared : squared;
  }
  return *result;
}

}  // namespace

RingPointer CellMap::ring(std::size_t dimension) {
  std::vector<std::string> names;
  for (std::size_t axis = 0; axis < dimension; ++axis) names.push_back("x" + std::to_string(axis));
  return std::make_shared<const PolynomialRing>(std::move(names));
}

CellMap::CellMap(std::vector<RationalFunction> map, Sides box, std::vector<Polynomial> positive,
                 std::vector<Polynomial> nonzero, std::optional<FormulaMap> formulas,
                 std::vector<Polynomial> nonnegative)
    : map_(std::move(map)),
      box_(std::move(box)),
      positive_(std::move(positive)),
      nonzero_(std::move(nonzero)),
      nonnegative_(std::move(nonnegative)),
      formulas_(std::move(formulas)) {
  std::vector<std::string> texts;
  for (const Polynomial& p : positive_) texts.push_back(p.text());
  for (const Polynomial& p : nonzero_) texts.push_back(p.text());
  for (const RationalFunction& f : map_) texts.push_back(f.numerator.text());
  for (const RationalFunction& f : map_) texts.push_back(f.denominator.text());
  std::vector<std::string> conditions;
  for (const Polynomial& p : nonnegative_) conditions.push_back(p.text());
  const std::vector<std::string>& names = map_.front().numerator.ring()->names();
  try {
    region_.emplace(names, conditions);
    try {
      const RationalFunction squares = sum_of_squares(map_, box_);
      auto more = texts;
      more.push_back(squares.numerator.text());
      more.push_back(squares.denominator.text());
      polynomials_.emplace(names, more);
      has_sum_of_squares_ = true;
    } catch (const std::length_error&) {
      polynomials_.emplace(names, texts);
    }
  } catch (const FormulaError&) {
    throw std::length_error("a polynomial is too large to be written out");
  }
}

CellMapEvaluation::CellMapEvaluation(const CellMap& map)
    : map_(map), m_(map.dimension()), region_(map.region()), polynomials_(map.polynomials()) {
  if (map.formulas()) formulas_.emplace(*map.formulas());
  for (std::size_t axis = 0; axis < m_; ++axis) {
    const Rational half_width = (map.box()[axis][1] - map.box()[axis][0]) / Rational(2);
    half_width_[axis] = scalar_from<Interval>(half_width);
    centre_[axis] = scalar_from<Interval>(map.box()[axis][0] + half_width);
  }
}

bool CellMapEvaluation::enclose(FormulaEvaluation<Interval>& functions, std::size_t count, const Cell& cell,
                                std::vector<Interval>& out) {
  out.resize(count);
  derivatives_.resize(count * m_);
  at_centre_.resize(count);
  if (!functions.first(cell.data(), out.data(), derivatives_.data())) return false;
  Cell centre;
  for (std::size_t axis = 0; axis < m_; ++axis) centre[axis] = Interval::exactly(middle_of(cell[axis]));
  if (!functions.value(centre.data(), at_centre_.data())) return true;
  for (std::size_t k = 0; k < count; ++k) {
    Interval centred = at_centre_[k];
    for (std::size_t axis = 0; axis < m_; ++axis) centred += derivatives_[k * m_ + axis] * (cell[axis] - centre[axis]);
    out[k] = common_part(out[k], centred);
  }
  return true;
}

bool CellMapEvaluation::misses_box(const MapOnCell& found, const Interval* squares) const {
  if (found.has_image && is_outside(found.image, map_.box())) return true;
  for (std::size_t axis = 0; axis < m_; ++axis) {
    const Interval& divisor = found.denominators[axis];
    if (is_as_large(found.numerators[axis] - centre_[axis] * divisor, half_width_[axis], divisor)) return true;
  }
  return squares != nullptr && is_as_large(squares[0], Interval(static_cast<int>(m_)), squares[1]);
}

MapOnCell CellMapEvaluation::on(const Cell& cell) {
  MapOnCell result;
  // Polynomials are defined everywhere.
  if (!map_.nonnegative().empty()) {
    (void)enclose(region_, map_.nonnegative().size(), cell, values_);
    for (const Interval& value : values_) {
      result.is_elsewhere = result.is_elsewhere || value.upper() < 0;
      result.is_here = result.is_here && value.lower() >= 0;
    }
  }
  if (!enclose(polynomials_, map_.polynomials().function_count(), cell, values_)) return result;
  const Interval* value = values_.data();
  result.is_positive = true;
  for (std::size_t k = 0; k < map_.positive().size(); ++k, ++value) {
    result.is_positive = result.is_positive && value->lower() > 0;
    result.is_excluded = result.is_excluded || value->upper() <= 0;
  }
  result.is_regular = result.is_positive;
  for (std::size_t k = 0; k < map_.nonzero().size(); ++k, ++value)
    result.is_regular = result.is_regular && vanishes_nowhere(*value);
  result.has_image = true;
  for (std::size_t axis = 0; axis < m_; ++axis) {
    result.numerators[axis] = value[axis];
    result.denominators[axis] = value[m_ + axis];
    result.has_image = result.has_image && vanishes_nowhere(value[m_ + axis]);
  }
  if (result.has_image) {
    for (std::size_t axis = 0; axis < m_; ++axis) result.image[axis] = value[axis] / value[m_ + axis];
    if (formulas_ && enclose(*formulas_, m_, cell, image_)) {
      for (std::size_t axis = 0; axis < m_; ++axis) result.image[axis] = common_part(result.image[axis], image_[axis]);
    }
  }
  result.is_regular = result.is_regular && result.has_image;
  result.is_excluded = result.is_excluded || result.is_elsewhere ||
                       misses_box(result, map_.has_sum_of_squares() ? value + 2 * m_ : nullptr);
  return result;
}

Cell cell_around(const Sides& box) {
  Cell result;
  for (std::size_t axis = 0; axis < box.size(); ++axis)
    result[axis] =
        Interval::between(scalar_from<Interval>(box[axis][0]).lower(), scalar_from<Interval>(box[axis][1]).upper());
  return result;
}

bool is_inside(const std::array<Interval, 3>& place, const Sides& box) {
  for (std::size_t axis = 0; axis < box.size(); ++axis) {
    if (!(place[axis].lower() >= scalar_from<Interval>(box[axis][0]).upper()) ||
        !(place[axis].upper() <= scalar_from<Interval>(box[axis][1]).lower()))
      return false;
  }
  return true;
}

bool is_outside(const std::array<Interval, 3>& place, const Sides& box) {
  for (std::size_t axis = 0; axis < box.size(); ++axis) {
    if (place[axis].upper() < scalar_from<Interval>(box[axis][0]).lower() ||
        place[axis].lower() > scalar_from<Interval>(box[axis][1]).upper())
      return true;
  }
  return false;
}

}  // namespace delcert
