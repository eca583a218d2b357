#include "kernel/manifold/submanifold/cover_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "kernel/parallel/parts.hpp"

namespace delcert {

namespace {

constexpr std::size_t pieces_at_first = 1024;
constexpr std::uint64_t most_parts_of_a_piece = 1U << 18U;
constexpr std::size_t most_open_of_a_piece = 4;

struct CoverCell {
  std::array<double, most_ambient_dimensions> lower{};
  std::array<double, most_ambient_dimensions> upper{};
};

/// A part of the box with the charts near it.
struct Piece {
  CoverCell cell;
  std::vector<std::uint32_t> charts;
};

/// How large parts are to be looked at, from all charts.
struct CoverScale {
  explicit CoverScale(const std::vector<TangentChart>& charts) {
    if (!charts.empty()) least_height = std::numeric_limits<double>::infinity();
    for (const TangentChart& chart : charts) {
      least_height = std::min(least_height, approximate_double(chart.data().height));
      // A point of M has a label within some sampling radius, and patches have three or more.
      reach = std::max(reach, approximate_double(chart.data().radius) / 2);
    }
  }
  double least_height = 0;
  double reach = 0;
};

/// What is found below a piece.
class CoverSearch {
 public:
  CoverSearch(const ZeroSet& zero_set, const std::vector<TangentChart>& charts, const CoverScale& scale)
      : charts_(charts),
        n_(zero_set.ambient()),
        m_(zero_set.dimension()),
        q_(zero_set.codimension()),
        f_(zero_set.map()),
        least_height_(scale.least_height),
        reach_(scale.reach),
        middle_(n_),
        half_(n_),
        x_(n_),
        value_(q_),
        box_value_(q_),
        derivative_(q_ * n_),
        central_(q_ * n_) {}

  /// Whether nothing is left to do: no zeros, or in a cylinder.
  bool is_done(const Piece& piece) {
    for (std::size_t axis = 0; axis < n_; ++axis) {
      const Interval lower = Interval::exactly(piece.cell.lower[axis]);
      const Interval upper = Interval::exactly(piece.cell.upper[axis]);
      const double centre = piece.cell.lower[axis] / 2 + piece.cell.upper[axis] / 2;
      middle_[axis] = Interval::exactly(centre);
      const Interval half = maximum(upper - middle_[axis], middle_[axis] - lower);
      half_[axis] = Interval::between(-half.upper(), half.upper());
      x_[axis] = Interval::between(piece.cell.lower[axis], piece.cell.upper[axis]);
    }
    const std::uint32_t* nearest = nearest_of(piece);
    if (nearest != nullptr && is_in_cylinder(charts_[*nearest])) return true;
    if (is_without_zeros()) return true;
    if (nearest == nullptr || widest(piece.cell).second > 4 * least_height_) return false;
    return std::any_of(piece.charts.begin(), piece.charts.end(),
                       [&](std::uint32_t label) { return is_in_cylinder(charts_[label]); });
  }

  /// Both halves across the widest side, with the charts near them.
  [[nodiscard]] std::array<Piece, 2> halves(const Piece& piece) const {
    const std::size_t axis = widest(piece.cell).first;
    std::array<Piece, 2> result;
    const double cut = piece.cell.lower[axis] / 2 + piece.cell.upper[axis] / 2;
    for (std::size_t side = 0; side < 2; ++side) {
      Piece& part = result[side];
      part.cell = piece.cell;
      (side == 0 ? part.cell.upper : part.cell.lower)[axis] = cut;
      for (const std::uint32_t label : piece.charts) {
        double squared = 0;
        for (std::size_t at = 0; at < n_; ++at) {
          const double c = charts_[label].enclosed().centre[at].lower();
          const double off = std::max(std::max(part.cell.lower[at] - c, c - part.cell.upper[at]), 0.0);
          squared += off * off;
        }
        if (squared <= reach_ * reach_) part.charts.push_back(label);
      }
    }
    return result;
  }

  [[nodiscard]] bool is_least(const CoverCell& cell) const {
    double size = 0;
    for (std::size_t axis = 0; axis < n_; ++axis)
      size = std::max({size, std::fabs(cell.lower[axis]), std::fabs(cell.upper[axis])});
    return widest(cell).second <= std::max(least_height_ / 8, size * 0x1p-30);
  }

  CoverReport below(Piece piece) {
    CoverReport result;
    std::vector<Piece> open;
    open.push_back(std::move(piece));
    while (!open.empty()) {
      const Piece part = std::move(open.back());
      open.pop_back();
      ++result.parts;
      if (is_done(part)) continue;
      if (is_least(part.cell) || result.parts > most_parts_of_a_piece) {
        const auto size = static_cast<std::ptrdiff_t>(n_);
        result.open.push_back({{part.cell.lower.begin(), part.cell.lower.begin() + size},
                               {part.cell.upper.begin(), part.cell.upper.begin() + size}});
        if (result.open.size() == most_open_of_a_piece || result.parts > most_parts_of_a_piece) return result;
        continue;
      }
      for (Piece& half : halves(part)) open.push_back(std::move(half));
    }
    return result;
  }

 private:
  [[nodiscard]] std::pair<std::size_t, double> widest(const CoverCell& cell) const {
    std::pair<std::size_t, double> result{0, 0};
    for (std::size_t axis = 0; axis < n_; ++axis) {
      const double width = cell.upper[axis] - cell.lower[axis];
      if (width > result.second) result = {axis, width};
    }
    return result;
  }

  [[nodiscard]] const std::uint32_t* nearest_of(const Piece& piece) const {
    const std::uint32_t* result = nullptr;
    double least = std::numeric_limits<double>::infinity();
    // Large parts have all charts near them, and need none.
    if (widest(piece.cell).second > 4 * reach_) return nullptr;
    for (const std::uint32_t& label : piece.charts) {
      double squared = 0;
      for (std::size_t axis = 0; axis < n_; ++axis) {
        const double off = charts_[label].enclosed().centre[axis].lower() - middle_[axis].lower();
        squared += off * off;
      }
      if (squared < least) {
        least = squared;
        result = &label;
      }
    }
    return result;
  }

  /// Of a part, by |T(x − c)| ≤ |T(centre − c)| + |T|·half in each coordinate.
  [[nodiscard]] bool is_in_cylinder(const TangentChart& chart) const {
    const EnclosedChart<Interval>& enclosed = chart.enclosed();
    Interval squared(0);
    for (std::size_t k = 0; k < n_; ++k) {
      Interval along = enclosed.coordinate(middle_.data(), k);
      for (std::size_t axis = 0; axis < n_; ++axis) along += enclosed.at(axis, k) * half_[axis];
      if (k < m_) {
        squared += square(along);
      } else if (!is_proved(less(absolute(along), scalar_from<Interval>(chart.data().height)))) {
        return false;
      }
    }
    return is_proved(less(squared, square(scalar_from<Interval>(chart.data().radius))));
  }

  /// By components, and by the combination wᵀf that is the distance along the Newton step to M, w = (JJᵀ)⁻¹f in the
  /// middle.
  bool is_without_zeros() {
    if (!f_.first(x_.data(), box_value_.data(), derivative_.data())) return false;
    for (const Interval& value : box_value_) {
      if (is_refuted(is_zero(value))) return true;
    }
    if (!f_.first(middle_.data(), value_.data(), central_.data())) return false;
    std::vector<double> weights(q_, 0);
    for (std::size_t row = 0; row < q_; ++row) {
      weights[row] = 1;
      if (is_bounded_away(weights)) return true;
      weights[row] = 0;
    }
    if (q_ == 1) return false;
    Dense<double> gram(q_ * q_, 0);
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t column = 0; column < q_; ++column) {
        for (std::size_t axis = 0; axis < n_; ++axis)
          gram[row * q_ + column] += central_[row * n_ + axis].lower() * central_[column * n_ + axis].lower();
      }
    }
    const auto inverse = inverse_of(std::move(gram), q_);
    if (!inverse) return false;
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t b = 0; b < q_; ++b) weights[row] += (*inverse)[row * q_ + b] * value_[b].lower();
      if (!(std::fabs(weights[row]) < std::numeric_limits<double>::max())) return false;
    }
    return is_bounded_away(weights);
  }

  /// Whether the sum of the equations with these weights has no zero in the part, by the mean-value form.
  [[nodiscard]] bool is_bounded_away(const std::vector<double>& weights) const {
    Interval range(0);
    for (std::size_t b = 0; b < q_; ++b) range += Interval::exactly(weights[b]) * value_[b];
    for (std::size_t axis = 0; axis < n_; ++axis) {
      Interval along(0);
      for (std::size_t b = 0; b < q_; ++b) along += Interval::exactly(weights[b]) * derivative_[b * n_ + axis];
      range += along * half_[axis];
    }
    return is_refuted(is_zero(range));
  }

  const std::vector<TangentChart>& charts_;
  std::size_t n_;
  std::size_t m_;
  std::size_t q_;
  FormulaEvaluation<Interval> f_;
  double least_height_;
  double reach_;
  std::vector<Interval> middle_;
  std::vector<Interval> half_;
  std::vector<Interval> x_;
  std::vector<Interval> value_;
  std::vector<Interval> box_value_;
  Dense<Interval> derivative_;
  Dense<Interval> central_;
};

/// Divides the box until there are pieces enough for all threads.
std::vector<Piece> first_pieces(const ZeroSet& zero_set, const std::vector<TangentChart>& charts,
                                const CoverScale& scale, CoverReport& report) {
  const RoundingGuard guard;
  CoverSearch search(zero_set, charts, scale);
  std::vector<Piece> pieces(1);
  for (std::size_t axis = 0; axis < zero_set.ambient(); ++axis) {
    pieces[0].cell.lower[axis] = scalar_from<Interval>(zero_set.description().box[axis][0]).lower();
    pieces[0].cell.upper[axis] = scalar_from<Interval>(zero_set.description().box[axis][1]).upper();
  }
  for (std::uint32_t label = 0; label < charts.size(); ++label) pieces[0].charts.push_back(label);
  while (!pieces.empty() && pieces.size() < pieces_at_first) {
    std::vector<Piece> next;
    for (const Piece& piece : pieces) {
      ++report.parts;
      if (search.is_done(piece)) continue;
      if (search.is_least(piece.cell)) return pieces;
      for (Piece& half : search.halves(piece)) next.push_back(std::move(half));
    }
    pieces = std::move(next);
  }
  return pieces;
}

}  // namespace

CoverReport check_cover(const ZeroSet& zero_set, const std::vector<TangentChart>& charts, const Progress& progress) {
  CoverReport result;
  const CoverScale scale(charts);
  const std::vector<Piece> pieces = first_pieces(zero_set, charts, scale, result);
  in_parts<4>(
      "cover the box", pieces.size(), progress,
      [&](std::size_t first, std::size_t last) {
        const RoundingGuard guard;
        CoverSearch search(zero_set, charts, scale);
        CoverReport found;
        for (std::size_t at = first; at < last; ++at) {
          CoverReport below = search.below(pieces[at]);
          found.parts += below.parts;
          for (BoxPart& part : below.open) found.open.push_back(std::move(part));
        }
        return found;
      },
      [&](CoverReport found) {
        result.parts += found.parts;
        for (BoxPart& part : found.open) result.open.push_back(std::move(part));
      });
  return result;
}

}  // namespace delcert
