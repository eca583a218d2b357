#include "proofs/prover/box.hpp"

namespace delcert {

namespace {

/// Bounds of the root, exact if it is rational.
Rational root_bound(const Rational& x, bool upper) {
  constexpr unsigned bits = 40;
  const Integer numerator = sqrt(x.numerator());
  const Integer denominator = sqrt(x.denominator());
  if (numerator * numerator == x.numerator() && denominator * denominator == x.denominator()) {
    return {numerator, denominator};
  }
  const Rational bound = upper ? square_root_upper(x, bits) : square_root_lower(x, bits);
  const long exponent = binary_exponent(bound) - static_cast<long>(bits);
  return upper ? rounded_up(bound, exponent) : rounded_down(bound, exponent);
}

Rational variable_at(const BoxSide& side, const Rational& parameter, bool upper) {
  return side.is_squared ? root_bound(parameter, upper) : parameter;
}

/// Precondition: lower < upper, or both closed and equal, 0 <= lower; the simplest fraction by Stern and Brocot.
Rational simplest(const Rational& lower, bool has_lower, const std::optional<Rational>& upper, bool has_upper) {
  Rational floor(floor_of(lower));
  const auto fits = [&](const Rational& x) {
    const bool above = lower < x || (has_lower && lower == x);
    return above && (!upper || x < *upper || (has_upper && x == *upper));
  };
  if (fits(floor)) return floor;
  if (fits(floor + Rational(1))) return floor + Rational(1);
  // floor < x < floor + 1: 1/(x − floor) lies between the inverses, the other way round.
  std::optional<Rational> greatest;
  if (lower > floor) greatest = Rational(1) / (lower - floor);
  return floor + Rational(1) / simplest(Rational(1) / (*upper - floor), has_upper, greatest, has_lower);
}

std::string text_of(const Rational& x) {
  return x.numerator().str() + (x.denominator() == 1 ? "" : "/" + x.denominator().str());
}

}  // namespace

OpenEnds BoxSide::unit_open() const {
  if (is_point()) return {};
  return {unit_lower == Rational(0) && map_open.lower, unit_upper == Rational(1) && map_open.upper};
}

BoxSide box_side(const StepRange& range, bool is_squared) {
  BoxSide side;
  side.is_integer = range.is_integer;
  side.is_squared = is_squared;
  side.lower = range.lower;
  side.upper = range.upper;
  side.open = {!range.has_lower, !range.has_upper};
  if (range.is_integer) {
    if (side.lower) {
      Rational first(ceiling_of(*side.lower));
      if (side.open.lower && first == *side.lower) first += Rational(1);
      side.lower = first;
      side.open.lower = false;
    }
    if (side.upper) {
      Rational last(floor_of(*side.upper));
      if (side.open.upper && last == *side.upper) last -= Rational(1);
      side.upper = last;
      side.open.upper = false;
    }
  }
  side.map_open = side.open;
  if (side.lower) {
    side.map.lower = variable_at(side, *side.lower, false);
    if (is_squared && square(*side.map.lower) != *side.lower) side.map_open.lower = true;
  }
  if (side.upper) {
    side.map.upper = variable_at(side, *side.upper, true);
    if (is_squared && square(*side.map.upper) != *side.upper) side.map_open.upper = true;
  }
  if (side.map.lower && side.map.upper && *side.map.lower == *side.map.upper) side.unit_upper = Rational(0);
  return side;
}

std::vector<Box> boxes_of(const std::vector<StepRange>& ranges, const std::vector<bool>& is_squared) {
  std::vector<Box> result{Box{}};
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    std::vector<StepRange> parts{ranges[i]};
    if (!ranges[i].lower && !ranges[i].upper) {
      StepRange below = ranges[i];
      below.upper = Rational(0);
      below.has_upper = true;
      StepRange above = ranges[i];
      above.lower = Rational(0);
      above.has_lower = true;
      parts = {below, above};
    }
    std::vector<Box> longer;
    for (const Box& box : result) {
      for (const StepRange& part : parts) {
        longer.push_back(box);
        longer.back().push_back(box_side(part, is_squared[i]));
      }
    }
    result = std::move(longer);
  }
  return result;
}

BoxCut middle_cut(const Box& box, std::size_t side) {
  const BoxSide& whole = box[side];
  const Rational variable = *whole.map.at((whole.unit_lower + whole.unit_upper) / Rational(2));
  const Rational parameter = whole.is_squared ? square(variable) : variable;
  if (!whole.is_integer) return {side, parameter, parameter};
  Rational last(floor_of(parameter));
  if (whole.lower) last = maximum(last, *whole.lower);
  if (whole.upper) last = minimum(last, *whole.upper - Rational(1));
  return {side, last, last + Rational(1)};
}

CutBox cut(const Box& box, const BoxCut& where) {
  CutBox result{box, box, {}, {}};
  const BoxSide& whole = box[where.side];
  BoxSide& lower = result.lower[where.side];
  BoxSide& upper = result.upper[where.side];
  lower.upper = where.lower_part;
  lower.open.upper = false;
  upper.lower = where.upper_part;
  upper.open.lower = false;
  // A root that is rounded may leave the box, of which the variable does not.
  lower.unit_upper = minimum(whole.map.inverse(variable_at(whole, where.lower_part, true)), whole.unit_upper);
  upper.unit_lower = maximum(whole.map.inverse(variable_at(whole, where.upper_part, false)), whole.unit_lower);
  result.lower_part_ends = lower.unit_upper;
  result.upper_part_begins = upper.unit_lower;
  return result;
}

ParameterBox parameter_box(const Box& box, PrecisionBits precision) {
  ParameterBox result;
  for (const BoxSide& side : box) {
    result.emplace_back(side.lower, !side.open.lower, side.upper, !side.open.upper, precision);
  }
  return result;
}

std::string box_text(const Box& box, const std::vector<std::string>& names) {
  std::string result;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const BoxSide& side = box[i];
    result += (i == 0 ? "" : ", ") + names[i];
    if (side.is_point()) {
      result += " = " + text_of(*side.lower);
    } else {
      const StepRange range{side.is_integer, side.lower, side.upper, side.lower && !side.open.lower,
                            side.upper && !side.open.upper};
      result += " in " + step_range_text(range);
    }
  }
  return result;
}

Rational simplest_in(const BoxSide& side) {
  const bool has_lower = side.lower && !side.open.lower;
  const bool has_upper = side.upper && !side.open.upper;
  Rational zero(0);
  const bool above = !side.lower || *side.lower < zero || (has_lower && *side.lower == zero);
  const bool below = !side.upper || *side.upper > zero || (has_upper && *side.upper == zero);
  if (above && below) return zero;
  if (above) {
    std::optional<Rational> greatest;
    if (side.lower) greatest = -*side.lower;
    return -simplest(-*side.upper, has_upper, greatest, has_lower);
  }
  return simplest(*side.lower, has_lower, side.upper, has_upper);
}

}  // namespace delcert
