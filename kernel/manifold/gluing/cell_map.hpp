#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernel/formula/formula_map.hpp"
#include "kernel/formula/rational_function.hpp"

namespace delcert {

/// The sides of a box: from, to.
using Sides = std::vector<std::array<Rational, 2>>;

/// A closed box with double corners; of the coordinates only those of the dimension at hand count.
using Cell = std::array<Interval, 3>;

/// A rational map from ℝᵐ to a box of ℝᵐ, m = 2, 3, with conditions on its domain, prepared for enclosures on cells.
/// The domain: where all polynomials of `positive` are above 0, none of `nonzero` and no denominator of the map
/// vanishes, and the map goes into the open box. The map may be one piece of several: then it counts where all
/// polynomials of `nonnegative` are at least 0.
class CellMap {
 public:
  /// The polynomials of a gluing are in these variables: x0, x1 …
  [[nodiscard]] static RingPointer ring(std::size_t dimension);

  /// `formulas`: the map once more, as somebody has written it, for tighter enclosures. Throws std::length_error if a
  /// polynomial is too large to be written out. Precondition: rounding to nearest; the functions are over `ring`.
  CellMap(std::vector<RationalFunction> map, Sides box, std::vector<Polynomial> positive,
          std::vector<Polynomial> nonzero, std::optional<FormulaMap> formulas,
          std::vector<Polynomial> nonnegative = {});

  [[nodiscard]] std::size_t dimension() const { return map_.size(); }
  [[nodiscard]] const std::vector<RationalFunction>& map() const { return map_; }
  [[nodiscard]] const Sides& box() const { return box_; }
  [[nodiscard]] const std::vector<Polynomial>& positive() const { return positive_; }
  [[nodiscard]] const std::vector<Polynomial>& nonzero() const { return nonzero_; }
  [[nodiscard]] const std::vector<Polynomial>& nonnegative() const { return nonnegative_; }
  /// The functions `nonnegative`.
  [[nodiscard]] const FormulaMap& region() const { return *region_; }
  /// positive, nonzero, numerators, denominators; and, unless they are too large, the numerator and the denominator of
  /// the sum of the squares of what the map is beyond the centre of the box, in half-widths.
  [[nodiscard]] const FormulaMap& polynomials() const { return *polynomials_; }
  [[nodiscard]] bool has_sum_of_squares() const { return has_sum_of_squares_; }
  [[nodiscard]] const std::optional<FormulaMap>& formulas() const { return formulas_; }

 private:
  std::vector<RationalFunction> map_;
  Sides box_;
  std::vector<Polynomial> positive_;
  std::vector<Polynomial> nonzero_;
  std::vector<Polynomial> nonnegative_;
  std::optional<FormulaMap> region_;
  std::optional<FormulaMap> polynomials_;
  bool has_sum_of_squares_ = false;
  std::optional<FormulaMap> formulas_;
};

/// What is certain of a map on a cell.
struct MapOnCell {
  bool is_positive = false;   ///< every polynomial of `positive` is above 0 on all of the cell
  bool is_regular = false;    ///< that, nothing that may not vanish vanishes, and the image is enclosed
  bool is_excluded = false;   ///< no point of the cell is in the domain
  bool is_elsewhere = false;  ///< no point of the cell is where the piece counts
  bool is_here = true;        ///< all points of the cell are where the piece counts
  bool has_image = false;
  std::array<Interval, 3> image;
  std::array<Interval, 3> numerators;
  std::array<Interval, 3> denominators;
};

/// Encloses values on cells, by the centred form of first order or plainly, whichever is tighter. Needs a
/// `RoundingGuard`, in the constructor too. Keeps a reference; has scratch memory.
class CellMapEvaluation {
 public:
  explicit CellMapEvaluation(const CellMap& map);
  [[nodiscard]] MapOnCell on(const Cell& cell);

 private:
  /// Of all functions of a map; false where one is not certainly defined on the cell.
  [[nodiscard]] bool enclose(FormulaEvaluation<Interval>& functions, std::size_t count, const Cell& cell,
                             std::vector<Interval>& out);
  [[nodiscard]] bool misses_box(const MapOnCell& found, const Interval* squares) const;

  const CellMap& map_;
  std::size_t m_;
  FormulaEvaluation<Interval> region_;
  FormulaEvaluation<Interval> polynomials_;
  std::optional<FormulaEvaluation<Interval>> formulas_;
  std::array<Interval, 3> centre_;
  std::array<Interval, 3> half_width_;
  std::vector<Interval> values_;
  std::vector<Interval> image_;
  std::vector<Interval> derivatives_;
  std::vector<Interval> at_centre_;
};

/// The closed box as a cell, rounded outwards. Needs a `RoundingGuard`.
[[nodiscard]] Cell cell_around(const Sides& box);
/// Whether all points that these enclose are in the closed box. Needs a `RoundingGuard`.
[[nodiscard]] bool is_inside(const std::array<Interval, 3>& place, const Sides& box);
/// Whether none of them is. Needs a `RoundingGuard`.
[[nodiscard]] bool is_outside(const std::array<Interval, 3>& place, const Sides& box);

}  // namespace delcert
