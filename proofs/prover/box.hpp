#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proofs/formula/step.hpp"
#include "proofs/prover/bernstein.hpp"
#include "proofs/prover/enclosure.hpp"

namespace delcert {

/// One parameter of a box: the numbers that it runs through there, and where its variable stands in the unit interval.
///
/// The variable is the parameter, or its root if the parameter is squared. That may be irrational at an end; then the
/// variable runs through a little more.
struct BoxSide {
  bool is_integer = false;
  bool is_squared = false;
  std::optional<Rational> lower;  ///< of the parameter; nothing: −∞
  std::optional<Rational> upper;
  OpenEnds open;      ///< of the parameter
  UnitMap map;        ///< of the variable; the same for all parts of one box
  OpenEnds map_open;  ///< which ends of the whole unit interval do not belong to the variable's range
  Rational unit_lower = Rational(0);
  Rational unit_upper = Rational(1);

  [[nodiscard]] bool is_point() const { return lower && upper && *lower == *upper; }
  /// Which ends of the variable's part of the unit interval do not belong to it.
  [[nodiscard]] OpenEnds unit_open() const;
};

using Box = std::vector<BoxSide>;

/// How a side is cut: the parameter is at most `lower_part` in one part and at least `upper_part` in the other. The two
/// are the same but for integers, where they are neighbours.
struct BoxCut {
  std::size_t side = 0;
  Rational lower_part;
  Rational upper_part;
};

/// The parts of a box, and where in the unit interval of the box they end and begin.
struct CutBox {
  Box lower;
  Box upper;
  Rational lower_part_ends;
  Rational upper_part_begins;
};

/// The side for a whole range. Precondition: not all of the real line.
[[nodiscard]] BoxSide box_side(const StepRange& range, bool is_squared);

/// The boxes that a range of parameters is made of: 2^n of them if n parameters run through the whole real line.
[[nodiscard]] std::vector<Box> boxes_of(const std::vector<StepRange>& ranges, const std::vector<bool>& is_squared);

/// Where to cut a side in the middle. Precondition: it is not a point.
[[nodiscard]] BoxCut middle_cut(const Box& box, std::size_t side);

/// Precondition: both numbers lie in the side's range; integers for integers.
[[nodiscard]] CutBox cut(const Box& box, const BoxCut& where);

/// For the enclosures of terms.
[[nodiscard]] ParameterBox parameter_box(const Box& box, PrecisionBits precision);

/// "[1, 2] x (0, infinity)", by name: "k in [1, 2], xi in (0, 1/4]".
[[nodiscard]] std::string box_text(const Box& box, const std::vector<std::string>& names);

/// The number of the side with the least denominator, of these the one nearest to 0.
[[nodiscard]] Rational simplest_in(const BoxSide& side);

}  // namespace delcert
