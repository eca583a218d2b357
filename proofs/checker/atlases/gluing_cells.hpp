#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "proofs/checker/arithmetic/map_piece.hpp"
#include "proofs/checker/certificate/gluing.hpp"

namespace delcert::checker {

/// A closed box of R^m.
using Cell = Matrix<Interval>;

/// A piece of a transition of the file or of the inverse of one, or one after another: a rational map into the open box
/// of a chart, where the polynomials of `positive` are above 0, those of `region` are not below 0, and those of
/// `nonzero` and the denominators do not vanish.
struct Passage {
  Passage(std::size_t m, std::size_t from_chart, std::size_t to_chart, const Sides& target, MapPiece piece,
          std::vector<Polynomial> above_zero, std::vector<Polynomial> not_zero, std::optional<FormulaMap> formulas);

  std::size_t from, to;
  const Sides* box;  // of `to`
  RationalMap map;
  std::vector<Polynomial> region, positive, nonzero;
  std::size_t number = 0;             // 2k of transition k, 2k + 1 of its inverse: all pieces have it
  std::optional<FormulaMap> written;  // the map as the file has it, or none
  FormulaMap borders;                 // `region`
  FormulaMap conditions;              // `positive`
  FormulaMap polynomials;             // positive, nonzero, numerators, denominators
  /// Numerator and denominator, in lowest terms, of sum ((map_k - c_k)/h_k)^2, for the centre and the half-widths of
  /// the box.
  FormulaMap squares;
};

/// What is certain of a passage on a cell.
struct OnCell {
  Verdict here = Verdict::proved;      // the cell is in the region; refuted: nowhere
  Verdict positive = Verdict::proved;  // all of `positive` are above 0; refuted: somewhere nowhere
  bool regular = false;                // that, and neither `nonzero` nor denominators vanish, and the image is enclosed
  bool excluded = false;               // no point of the cell is in the domain
  bool has_image = false;
  Cell image, numerators, denominators;
};

/// Encloses a passage on cells. Keeps a reference.
class PassageValues {
 public:
  explicit PassageValues(const Passage& passage);
  OnCell on(const Cell& cell);
  /// Of Dmap, on a cell on which it is regular; after it `second` has the second derivatives. Only with formulas.
  Matrix<Interval> jacobian(const Cell& cell);
  const Interval& second(std::size_t function, std::size_t k, std::size_t l) const {
    return written_->second(function, k, l);
  }
  const Passage& passage() const { return passage_; }

 private:
  const Passage& passage_;
  FormulaValues<Interval> borders_, polynomials_, squares_;
  std::unique_ptr<FormulaValues<Interval>> written_;
};

/// Values on the cell: plainly, and from the middle by the derivatives; whatever is in both.
Cell enclosed_values(FormulaValues<Interval>& functions, const Cell& cell);
Cell middle_of(const Cell& cell);
Cell cell_of(const Sides& sides);
/// Whether all points of the cell are in the box, open or closed; none is in the closed box.
bool is_inside_open(const Cell& cell, const Sides& box);
bool is_inside_closed(const Cell& cell, const Sides& box);
bool is_outside(const Cell& cell, const Sides& box);
/// The halves across an axis.
std::array<Cell, 2> halves(const Cell& cell, std::size_t axis);

enum class CellState { settled, broken, open };
/// Cells into which a cell is divided until each is settled. What is left, when it has become small: all cells, or one.
struct Division {
  bool broken = false;  // then `left` is the cell where it was found
  std::vector<Cell> left;
};
Division divided(const Cell& whole, std::size_t most_halvings, bool all,
                 const std::function<CellState(const Cell&)>& state);

/// All passages of a gluing, by their numbers. Calls not_inverse(k) for transitions of
/// which map and inverse are not inverse to one another; then nothing else of them is true. Throws Undecided.
std::vector<Passage> passages_of(const Gluing& gluing, const std::function<void(std::size_t)>& not_inverse);
/// The places of the passages of each number.
std::vector<std::vector<std::size_t>> by_number(const std::vector<Passage>& passages);

}  // namespace delcert::checker
