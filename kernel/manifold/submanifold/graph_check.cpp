#include "kernel/manifold/submanifold/graph_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "kernel/manifold/submanifold/fibre_zero.hpp"
#include "kernel/manifold/submanifold/spectral_norm.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/parallel/parts.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The symmetric part of 1 − Y·Df·N is asked to be below this and not only below 1: there is room for readers.
constexpr double greatest_defect = 0.98;

using Coordinates = std::array<double, most_ambient_dimensions>;

/// A box in the coordinates (y, z) of a cylinder, by its ends, which neighbours share; and between which |y|/ϱ slopes
/// are looked at in it.
struct Cell {
  Coordinates lower{};
  Coordinates upper{};
  double from = 0;
  double to = 1;

  [[nodiscard]] double middle(std::size_t k) const { return lower[k] / 2 + upper[k] / 2; }
  /// How far points are from the middle.
  [[nodiscard]] Interval half(std::size_t k) const {
    const Interval at = Interval::exactly(middle(k));
    return maximum(Interval::exactly(upper[k]) - at, at - Interval::exactly(lower[k]));
  }
  [[nodiscard]] Interval greatest(std::size_t k) const {
    return Interval::exactly(std::max(std::fabs(lower[k]), std::fabs(upper[k])));
  }
  [[nodiscard]] Interval least(std::size_t k) const { return Interval::exactly(std::max({lower[k], -upper[k], 0.0})); }
};

/// p(s) = (1 + 7s)/8: where |y| = sϱ, slopes may be Lp(s). P(s) = (2s + 7s²)/16, the integral: M is at most LϱP(s) from
/// z₀.
Interval profile(const Interval& s) { return (Interval(1) + Interval(7) * s) / Interval(8); }
Interval profile_integral(const Interval& s) { return (Interval(2) * s + Interval(7) * square(s)) / Interval(16); }

/// Between these, from the rim inwards, slopes are looked at one after the other: p(from) is to·0.85, but for 0.
std::vector<std::pair<double, double>> shells() {
  std::vector<std::pair<double, double>> result;
  for (double to = 1; to > 0;) {
    const double from = std::max(std::ldexp(std::floor(std::ldexp((8 * 0.85 * to - 1) / 7, 10)), -10), 0.0);
    result.emplace_back(from, to);
    to = from;
  }
  return result;
}

Interval norm_of(const std::vector<Interval>& entries) {
  Interval sum(0);
  for (const Interval& entry : entries) sum += square(entry);
  return square_root(sum);
}

/// The cells of one cylinder.
class Cylinder {
 public:
  Cylinder(FormulaEvaluation<Interval>& f, const TangentChart& chart, const Rational& slope, std::size_t most_cells)
      : f_(f),
        most_cells_(most_cells),
        chart_(chart.enclosed()),
        n_(chart.ambient()),
        m_(chart.dimension()),
        q_(n_ - m_),
        radius_(scalar_from<Interval>(chart.data().radius)),
        height_(scalar_from<Interval>(chart.data().height)),
        slope_(scalar_from<Interval>(slope)),
        at_(n_),
        x_(n_),
        value_(q_),
        derivative_(q_ * n_),
        second_(q_ * n_ * n_) {}

  bool is_transversal() { return is_transversal_at_once() || !look_at_all(Aim::transversal); }
  std::optional<GraphFailure> failure() {
    if (auto reason = outside_of_centre()) return GraphFailure{*reason, true};
    if (!is_transversal_at_once()) {
      if (auto result = look_at_all(Aim::transversal)) return result;
    }
    if (is_flat_at_once()) return std::nullopt;
    return look_at_all(Aim::flat);
  }

 private:
  /// What cells are looked at for: fibres on all of the cylinder, slopes in the cone.
  enum class Aim : unsigned char { transversal, flat };
  enum class Outcome : unsigned char { holds, open, fails, undefined };

  /// Y·Df·T at the place in `at_`.
  std::optional<Dense<Interval>> entries_at_place() {
    chart_.position(at_.data(), x_.data());
    if (!f_.first(x_.data(), value_.data(), derivative_.data())) return std::nullopt;
    return product(product(chart_.preconditioner, derivative_, q_, n_), chart_.frame, n_, n_);
  }
  /// `bends_` of w·f in the box with these half sides about the place in `at_`, whose position `x_` has.
  bool bends_about_place(const Dense<Interval>& weights, const std::vector<Interval>& half) {
    for (std::size_t axis = 0; axis < n_; ++axis) {
      for (std::size_t k = 0; k < n_; ++k) x_[axis] += chart_.at(axis, k) * (half[k] * Interval::between(-1, 1));
    }
    if (!f_.second(x_.data(), value_.data(), derivative_.data(), second_.data())) return false;
    second_order(weights);
    return true;
  }
  enum class Block : unsigned char { tangent, normal };
  /// The greatest norm of Σ_k t_k·B_k over all axes k, |(t_1 … t_m)| ≤ across, |(t_{m+1} … t_N)| ≤ above, for the
  /// matrices B_k = bend(·, k, ·) in the columns of the plane, or the symmetric parts of these in the others: of the
  /// middles, as they are in ℝ^(q·columns), by the spectral norms of both parts and of the products of one with the
  /// other, of the rest by the norm of Frobenius.
  [[nodiscard]] Interval change(Block block, const Interval& across, const Interval& above) const {
    const std::size_t columns = block == Block::tangent ? m_ : q_;
    std::vector<Interval> parts[2];
    Interval rests[2] = {Interval(0), Interval(0)};
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t l = 0; l < columns; ++l) {
        for (std::size_t k = 0; k < n_; ++k) {
          const Interval entry =
              block == Block::tangent ? bend(row, k, l) : (bend(row, k, m_ + l) + bend(l, k, m_ + row)) / Interval(2);
          const double middle = middle_of(entry);
          if (!std::isfinite(middle)) return Interval::between(0, std::numeric_limits<double>::infinity());
          parts[k < m_ ? 0 : 1].push_back(Interval::exactly(middle));
          rests[k < m_ ? 0 : 1] += square(entry - Interval::exactly(middle));
        }
      }
    }
    std::vector<Interval> mixed(m_ * q_, Interval(0));
    for (std::size_t entry = 0; entry < q_ * columns; ++entry) {
      for (std::size_t k = 0; k < m_; ++k) {
        for (std::size_t l = 0; l < q_; ++l) mixed[k * q_ + l] += parts[0][entry * m_ + k] * parts[1][entry * q_ + l];
      }
    }
    const Interval flat = spectral_norm(parts[0], m_) * across;
    const Interval high = spectral_norm(parts[1], q_) * above;
    // No product is greater than that of the norms.
    const Interval both = minimum(spectral_norm(mixed, q_) * across * above, flat * high);
    return square_root(square(flat) + square(high) + Interval(2) * both) + square_root(rests[0]) * across +
           square_root(rests[1]) * above;
  }
  [[nodiscard]] std::vector<Interval> half_sides(const Interval& height) const {
    std::vector<Interval> result(n_, radius_);
    for (std::size_t k = m_; k < n_; ++k) result[k] = height;
    return result;
  }

  /// The symmetric part of 1 − Y·Df·N on all of the cylinder, by Df at its centre and D²f on all of it.
  bool is_transversal_at_once() {
    for (Interval& coordinate : at_) coordinate = Interval(0);
    const auto entries = entries_at_place();
    if (!entries || !bends_about_place(chart_.preconditioner, half_sides(height_))) return false;
    const Interval high = square_root(Interval(static_cast<int>(q_))) * height_;
    const Interval most = distance_from_identity(*entries) + change(Block::normal, radius_, high);
    return is_proved(less(most, Interval::exactly(greatest_defect)));
  }

  /// The slopes where the rule asks for them, by Df at the point over the centre and D²f on a box around: at |y| = sϱ
  /// and |z − z₀| ≤ LϱP(s) the N-block of (Df·N)⁻¹ at that point times Df·T is the identity and what has a
  /// symmetric part of at most e(s), and the E-block is at most b(s), both norms of (sϱ, LϱP(s)) that grow with either
  /// and numbers. L·p(s)·(1 − e(s)) −
  /// b(s) is concave in s, so it is positive if it is at the centre and at the rim.
  bool is_flat_at_once() {
    at_ = foot_;
    const auto at_foot = entries_at_place();
    const auto adapted = at_foot ? adapted_to(*at_foot) : std::nullopt;
    if (!adapted) return false;
    const Dense<Interval> entries = product(*adapted, *at_foot, q_, n_);
    const Interval highest = slope_ * radius_ * profile_integral(Interval(1));
    if (!bends_about_place(product(*adapted, chart_.preconditioner, q_, q_), half_sides(highest))) return false;
    const Interval defect = distance_from_identity(entries);
    const Interval rise = tangential_norm(entries);
    const Interval rim_defect = defect + change(Block::normal, radius_, highest);
    const Interval rim_rise = rise + change(Block::tangent, radius_, highest);
    return over(rise, defect) < (slope_ * profile(Interval(0))).lower() && over(rim_rise, rim_defect) < slope_.lower();
  }

  std::optional<GraphFailure> look_at_all(Aim aim) {
    Cell whole;
    for (std::size_t k = 0; k < n_; ++k) {
      whole.upper[k] = (k < m_ ? radius_ : height_).upper();
      whole.lower[k] = -whole.upper[k];
    }
    std::vector<Cell> open(1, whole);
    if (aim == Aim::flat) {
      open.clear();
      for (const auto& [from, to] : shells()) {
        whole.from = from;
        whole.to = to;
        open.insert(open.begin(), whole);
      }
    }
    for (std::size_t looked_at = 0; !open.empty(); ++looked_at) {
      Cell cell = open.back();
      open.pop_back();
      std::size_t longest = 0;
      const Outcome outcome = look_at(cell, aim, longest);
      if (outcome == Outcome::holds) continue;
      if (outcome == Outcome::undefined) return GraphFailure{"the equations are not defined in its patch", false};
      if (outcome == Outcome::fails && aim == Aim::transversal)
        return GraphFailure{"its patch is no graph: fibres are not transversal", false};
      if (outcome == Outcome::fails) return GraphFailure{"its patch is steeper than the slope", true};
      if (looked_at > most_cells_) return GraphFailure{"undecided whether its patch is a graph", true};
      const double cut = cell.middle(longest);
      open.push_back(cell);
      open.back().upper[longest] = cut;
      open.push_back(cell);
      open.back().lower[longest] = cut;
    }
    return std::nullopt;
  }

  /// The point over the centre, and the lid above the cone over it.
  std::optional<std::string> outside_of_centre() {
    const std::vector<Interval> origin(m_, Interval(0));
    const auto heights = zero_on_fibre<Interval>(f_, chart_, origin.data());
    if (!heights) return "no point of the manifold is certain over its centre";
    foot_.assign(m_, Interval(0));
    foot_.insert(foot_.end(), heights->begin(), heights->end());
    offset_ = Interval::exactly(norm_of(*heights).upper());
    if (!is_proved(less(offset_ + slope_ * radius_ * profile_integral(Interval(1)), height_)))
      return "the lid of its patch is too low";
    return std::nullopt;
  }

  /// ‖S‖, S the symmetric part of 1 − (block of N) of entries of Y·Df·T. Where it is below 1, ⟨v, Bv⟩ ≥ (1 − ‖S‖)|v|²
  /// for that block B, so it is invertible and ‖B⁻¹‖ ≤ 1/(1 − ‖S‖).
  Interval distance_from_identity(const Dense<Interval>& entries) const {
    const auto entry = [&](std::size_t row, std::size_t column) { return entries[row * n_ + m_ + column]; };
    Interval sum(0);
    for (std::size_t row = 0; row < q_; ++row) {
      sum += square(Interval(1) - entry(row, row));
      for (std::size_t column = 0; column < row; ++column)
        sum += square(entry(row, column) + entry(column, row)) / Interval(2);
    }
    return square_root(sum);
  }

  /// a·b, rows·inner and inner·columns.
  static Dense<Interval> product(const Dense<Interval>& a, const Dense<Interval>& b, std::size_t inner,
                                 std::size_t columns) {
    const std::size_t rows = a.size() / inner;
    Dense<Interval> result(rows * columns, Interval(0));
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t k = 0; k < inner; ++k) {
        for (std::size_t column = 0; column < columns; ++column)
          result[row * columns + column] += a[row * inner + k] * b[k * columns + column];
      }
    }
    return result;
  }

  /// Nearly (Df·N)⁻¹ times what Y·Df·N is in the middle: from entries of Y·Df·T. None if that is singular.
  std::optional<Dense<Interval>> adapted_to(const Dense<Interval>& entries) const {
    Dense<double> normal(q_ * q_);
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t column = 0; column < q_; ++column)
        normal[row * q_ + column] = middle_of(entries[row * n_ + m_ + column]);
    }
    const auto inverse = inverse_of(std::move(normal), q_);
    if (!inverse) return std::nullopt;
    Dense<Interval> result;
    for (const double entry : *inverse) {
      if (!(std::fabs(entry) < std::numeric_limits<double>::max())) return std::nullopt;
      result.push_back(Interval::exactly(entry));
    }
    return result;
  }
  static double middle_of(const Interval& x) { return x.lower() / 2 + x.upper() / 2; }

  /// Makes the cell smaller, to what contains its part in the cylinder, or in the bent cone for slopes. False if there
  /// is none.
  bool clip(Cell& cell, Aim aim) const {
    Interval nearest(0);
    for (std::size_t k = 0; k < m_; ++k) nearest += square(cell.least(k));
    const Interval most = aim == Aim::flat ? radius_ * Interval::exactly(cell.to) : radius_;
    if (is_proved(less(square(most), nearest))) return false;
    for (std::size_t k = 0; k < m_; ++k)
      cut(cell, k, square_root(square(most) - (nearest - square(cell.least(k)))).upper());
    if (aim == Aim::transversal) return true;
    Interval farthest(0);
    Interval lowest(0);
    for (std::size_t k = 0; k < m_; ++k) farthest += square(cell.greatest(k));
    if (is_proved(less(farthest, square(radius_ * Interval::exactly(cell.from))))) return false;
    cell.from = std::max(cell.from, (square_root(nearest) / radius_).lower());
    cell.to = std::min(cell.to, (square_root(farthest) / radius_).upper());
    const Interval steepest = slope_ * radius_ * profile_integral(Interval::exactly(cell.to)) + offset_;
    for (std::size_t k = m_; k < n_; ++k) {
      lowest += square(cell.least(k));
      cut(cell, k, steepest.upper());
    }
    return !is_proved(less(square(steepest), lowest));
  }
  /// To |coordinate| ≤ most, if that leaves something.
  static void cut(Cell& cell, std::size_t k, double most) {
    const double upper = std::min(cell.upper[k], most);
    const double lower = std::max(cell.lower[k], -most);
    if (!(lower < upper)) return;
    cell.upper[k] = upper;
    cell.lower[k] = lower;
  }

  /// What the slope may be at the middle of a cell, if that is certainly in the cylinder, and for slopes in the bent
  /// cone.
  [[nodiscard]] std::optional<Interval> bound_at_middle(const Cell& cell, Aim aim) const {
    Interval across(0);
    Interval above(0);
    for (std::size_t k = 0; k < n_; ++k) (k < m_ ? across : above) += square(Interval::exactly(cell.middle(k)));
    if (!is_proved(less(across, square(radius_)))) return std::nullopt;
    const Interval s = square_root(across) / radius_;
    if (aim == Aim::flat && !is_proved(less(square_root(above) + offset_, slope_ * radius_ * profile_integral(s))))
      return std::nullopt;
    return slope_ * profile(s);
  }

  /// `longest`: the side of the cell that the enclosure depends on most.
  Outcome look_at(Cell& cell, Aim aim, std::size_t& longest) {
    if (!clip(cell, aim)) return Outcome::holds;
    for (std::size_t k = 0; k < n_; ++k) {
      if (cell.upper[k] - cell.lower[k] > cell.upper[longest] - cell.lower[longest]) longest = k;
      at_[k] = Interval::exactly(cell.middle(k));
    }
    const auto at_middle = entries_at_place();
    if (!at_middle) return Outcome::undefined;
    Dense<Interval> weights = chart_.preconditioner;
    Dense<Interval> entries = *at_middle;
    // What fails in the middle fails.
    const auto bound = bound_at_middle(cell, aim);
    if (aim == Aim::flat) {
      const auto adapted = adapted_to(entries);
      if (!adapted) return bound ? Outcome::fails : Outcome::open;
      weights = product(*adapted, weights, q_, q_);
      entries = product(*adapted, entries, q_, n_);
      if (bound && !(steepness_in(entries) <= bound->upper())) return Outcome::fails;
    } else if (bound && !is_refuted(less(Interval(1), distance_from_identity(entries)))) {
      return Outcome::fails;
    }
    std::vector<Interval> half;
    for (std::size_t k = 0; k < n_; ++k) half.push_back(cell.half(k));
    if (!bends_about_place(weights, half)) return Outcome::open;
    return enclosed_in(cell, aim, entries, longest) ? Outcome::holds : Outcome::open;
  }

  /// bends_[(a·N + k)·N + l] = (Tᵀ(Σ_b w_ab D²f_b)T)_kl.
  void second_order(const Dense<Interval>& weights) {
    bends_.clear();
    const Dense<Interval> hessians = product(weights, second_, q_, n_ * n_);
    for (std::size_t row = 0; row < q_; ++row) {
      const auto from = hessians.begin() + static_cast<std::ptrdiff_t>(row * n_ * n_);
      const Dense<Interval> right = product({from, from + static_cast<std::ptrdiff_t>(n_ * n_)}, chart_.frame, n_, n_);
      for (std::size_t k = 0; k < n_; ++k) {
        for (std::size_t l = 0; l < n_; ++l) {
          Interval sum(0);
          for (std::size_t a = 0; a < n_; ++a) sum += chart_.at(a, k) * right[a * n_ + l];
          bends_.push_back(sum);
        }
      }
    }
  }
  [[nodiscard]] const Interval& bend(std::size_t row, std::size_t k, std::size_t l) const {
    return bends_[(row * n_ + k) * n_ + l];
  }

  /// ‖E-block‖/(1 − ‖1 − N-block‖); unbounded if there is no such bound.
  [[nodiscard]] double steepness_in(const Dense<Interval>& entries) const {
    return over(tangential_norm(entries), distance_from_identity(entries));
  }
  [[nodiscard]] Interval tangential_norm(const Dense<Interval>& entries) const {
    Interval squared(0);
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t l = 0; l < m_; ++l) squared += square(entries[row * n_ + l]);
    }
    return square_root(squared);
  }
  static double over(const Interval& tangential, const Interval& theta) {
    if (!is_proved(less(theta, Interval(1)))) return std::numeric_limits<double>::infinity();
    return (tangential / (Interval(1) - theta)).upper();
  }

  /// By the mean-value form, entries + Σ_k bend_k (t_k − middle_k). For slopes also with the bends in the plane split
  /// into numbers B and what is left: ‖e − By‖ + ‖B‖|y| + …, as |y| ≤ ϱ says more than the cell where it is cut by the
  /// rim.
  bool enclosed_in(const Cell& cell, Aim aim, Dense<Interval> entries, std::size_t& longest) const {
    Dense<Interval> rest(q_ * m_);
    Dense<Interval> flat(q_ * m_ * m_);
    Interval apart(0);
    Interval left(0);
    Coordinates share{};
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t l = 0; l < m_; ++l) rest[row * m_ + l] = entries[row * n_ + l];
      for (std::size_t l = 0; l < n_; ++l) {
        Interval unsplit(0);
        for (std::size_t k = 0; k < n_; ++k) {
          const Interval half = cell.half(k);
          const Interval all = absolute(bend(row, k, l)) * half;
          Interval part = all;
          if (k < m_ && l < m_) {
            const Interval middle = Interval::exactly(middle_of(bend(row, k, l)));
            flat[(row * m_ + l) * m_ + k] = middle;
            rest[row * m_ + l] -= middle * Interval::exactly(cell.middle(k));
            part = absolute(bend(row, k, l) - middle) * half;
          }
          if (l < m_) unsplit += part;
          share[k] += aim == Aim::flat ? (part + all / Interval(8)).upper() : all.upper();
          entries[row * n_ + l] += Interval::between(-all.upper(), all.upper());
        }
        if (l < m_) left += square(unsplit);
      }
      for (std::size_t l = 0; l < m_; ++l) apart += square(rest[row * m_ + l]);
    }
    const auto most = static_cast<std::size_t>(std::max_element(share.begin(), share.end()) - share.begin());
    if (share[most] < std::numeric_limits<double>::infinity()) longest = most;
    if (aim == Aim::transversal)
      return is_proved(less(distance_from_identity(entries), Interval::exactly(greatest_defect)));
    const double allowed = (slope_ * profile(Interval::exactly(cell.from))).lower();
    if (steepness_in(entries) <= allowed) return true;
    const Interval split =
        square_root(apart) + spectral_norm(flat, m_) * Interval::exactly(cell.to) * radius_ + square_root(left);
    return over(split, distance_from_identity(entries)) <= allowed;
  }

  FormulaEvaluation<Interval>& f_;
  std::size_t most_cells_;
  const EnclosedChart<Interval>& chart_;
  std::size_t n_;
  std::size_t m_;
  std::size_t q_;
  Interval radius_;
  Interval height_;
  Interval slope_;
  Interval offset_;
  std::vector<Interval> foot_;  // the point over the centre, (0, z₀)
  std::vector<Interval> at_;
  std::vector<Interval> x_;
  std::vector<Interval> value_;
  Dense<Interval> derivative_;
  Dense<Interval> second_;
  Dense<Interval> bends_;
};

}  // namespace

GraphCheck::GraphCheck(const ZeroSet& zero_set) : zero_set_(zero_set) {}

std::optional<GraphFailure> GraphCheck::outside_of_box(const TangentChart& chart) const {
  const std::size_t n = chart.ambient();
  const EnclosedChart<Interval>& enclosed = chart.enclosed();
  const Interval radius = scalar_from<Interval>(chart.data().radius);
  const Interval height = scalar_from<Interval>(chart.data().height);
  for (std::size_t axis = 0; axis < n; ++axis) {
    Interval across(0);
    Interval along(0);
    for (std::size_t column = 0; column < chart.dimension(); ++column) across += square(enclosed.at(axis, column));
    for (std::size_t column = chart.dimension(); column < n; ++column) along += absolute(enclosed.at(axis, column));
    const Interval reach = square_root(across) * radius + along * height;
    const auto& side = zero_set_.description().box[axis];
    if (!is_proved(conjunction(less(scalar_from<Interval>(side[0]), enclosed.centre[axis] - reach),
                               less(enclosed.centre[axis] + reach, scalar_from<Interval>(side[1])))))
      return GraphFailure{"its patch is not inside of the box, across " + zero_set_.description().variables[axis],
                          false};
  }
  return std::nullopt;
}

std::optional<GraphFailure> GraphCheck::failure(const TangentChart& chart, const Rational& slope) {
  constexpr std::size_t most_cells = 6000;
  const RoundingGuard guard;
  if (auto result = outside_of_box(chart)) return result;
  FormulaEvaluation<Interval> f(zero_set_.map());
  return Cylinder(f, chart, slope, most_cells).failure();
}

bool GraphCheck::may_be_as_high(const TangentChart& chart) {
  constexpr std::size_t most_cells = 100;
  const RoundingGuard guard;
  if (outside_of_box(chart)) return false;
  FormulaEvaluation<Interval> f(zero_set_.map());
  return Cylinder(f, chart, Rational(0), most_cells).is_transversal();
}

namespace {

/// The slope is greater than needed by this: the more, the fewer cells, here and for whoever checks it.
constexpr std::array slope_slacks{1.6, 1.25};
constexpr double last_slack = 1.1;
/// Of these factors the narrow ones hold most balls of level 1 and few of level 2s.
constexpr std::size_t wide_factors = 3;
constexpr long slope_exponent = -8;
/// What is not so at all charts is mostly seen at some of them.
constexpr std::size_t most_suspects = 64;
constexpr std::size_t most_estimates = 1024;

/// ζ > |z₀| + 9Lϱ/16 by a little, with few digits.
Rational least_height(const Rational& radius, const Rational& slope) {
  const Rational needed =
      radius * slope * Rational(Integer(9), Integer(16)) * (Rational(1) + Rational::power_of_two(-6));
  return rounded_up(needed, binary_exponent(needed) - 6);
}

Rational eighths(const Rational& unit, int number) { return unit * Rational(Integer(number), Integer(8)); }

/// In doubles, how steep M and the level sets near it are in this chart, where the cone of this slope meets the rim of
/// the patch.
class SlopeEstimate {
 public:
  explicit SlopeEstimate(const ZeroSet& zero_set)
      : n_(zero_set.ambient()),
        m_(zero_set.dimension()),
        f_(zero_set.map()),
        x_(n_),
        value_(n_ - m_),
        derivative_((n_ - m_) * n_) {}

  double estimate(const TangentChart& chart, double radius, double slope) {
    const auto& enclosed = chart.enclosed();
    double result = 0;
    std::size_t directions = 1;
    for (std::size_t k = 0; k < m_; ++k) directions *= 3;
    for (std::size_t code = 0; code < directions; ++code) {
      std::vector<double> y(n_, 0);
      std::size_t rest = code;
      double length = 0;
      for (std::size_t k = 0; k < m_; ++k, rest /= 3) {
        y[k] = static_cast<double>(rest % 3) - 1;
        length += y[k] * y[k];
      }
      if (length == 0) continue;
      for (const double s : {0.5, 1.0}) {
        std::vector<double> at(n_, 0);
        for (std::size_t k = 0; k < m_; ++k) at[k] = y[k] * s * radius / std::sqrt(length);
        for (std::size_t b = m_; b < n_; ++b) {
          for (const double sign : {-1.0, 1.0}) {
            at[b] = sign * slope * radius * (2 * s + 7 * s * s) / 16;
            result = std::max(result, slope_at(enclosed, at) * 8 / (1 + 7 * s));
          }
          at[b] = 0;
        }
      }
    }
    return result;
  }

 private:
  double slope_at(const EnclosedChart<Interval>& chart, const std::vector<double>& y) {
    for (std::size_t axis = 0; axis < n_; ++axis) {
      x_[axis] = chart.centre[axis].lower();
      for (std::size_t k = 0; k < n_; ++k) x_[axis] += chart.at(axis, k).lower() * y[k];
    }
    if (!f_.first(x_.data(), value_.data(), derivative_.data())) return std::numeric_limits<double>::infinity();
    const std::size_t q = n_ - m_;
    Dense<double> entries(q * n_, 0);
    Dense<double> normal(q * q);
    for (std::size_t row = 0; row < q; ++row) {
      for (std::size_t column = 0; column < n_; ++column) {
        for (std::size_t axis = 0; axis < n_; ++axis)
          entries[row * n_ + column] += derivative_[row * n_ + axis] * chart.at(axis, column).lower();
        if (column >= m_) normal[row * q + column - m_] = entries[row * n_ + column];
      }
    }
    const auto inverse = inverse_of(std::move(normal), q);
    if (!inverse) return std::numeric_limits<double>::infinity();
    double result = 0;
    for (std::size_t row = 0; row < q; ++row) {
      for (std::size_t column = 0; column < m_; ++column) {
        double entry = 0;
        for (std::size_t b = 0; b < q; ++b) entry += (*inverse)[row * q + b] * entries[b * n_ + column];
        result += entry * entry;
      }
    }
    return std::sqrt(result);
  }

  std::size_t n_;
  std::size_t m_;
  FormulaEvaluation<double> f_;
  std::vector<double> x_;
  std::vector<double> value_;
  Dense<double> derivative_;
};

class Fitting {
 public:
  Fitting(const ZeroSet& zero_set, const std::vector<std::vector<Rational>>& centres, const SamplingRadii& radii,
          const Progress& progress)
      : zero_set_(zero_set), radii_(radii), progress_(progress) {
    in_parts(
        "make charts", centres.size(), progress,
        [&](std::size_t first, std::size_t last) {
          FormulaEvaluation<double> f(zero_set.map());
          std::vector<TangentChart> found;
          for (std::size_t at = first; at < last; ++at) found.push_back(tangent_chart(zero_set, f, centres[at]));
          return found;
        },
        [&](std::vector<TangentChart> found) {
          for (TangentChart& chart : found) charts_.push_back(std::move(chart));
        });
    for (std::size_t at = 0; at < charts_.size(); ++at) all_.push_back(at);
  }

  FittedCharts fit() {
    std::string reason;
    const auto found = [&](std::size_t first, std::size_t last, const auto& slacks) -> std::optional<FittedCharts> {
      for (std::size_t at = first; at < last; ++at) {
        const Rational factor = Rational(patch_quarters[at]) / Rational(4);
        for (const double slack : slacks) {
          if (auto slope = fitting_slope(factor, slack, reason))
            return FittedCharts{std::move(charts_), std::move(*slope), factor};
        }
      }
      return std::nullopt;
    };
    const std::array last_slacks{last_slack};
    if (auto charts = found(0, wide_factors, slope_slacks)) return *std::move(charts);
    if (auto charts = found(0, wide_factors, last_slacks)) return *std::move(charts);
    if (auto charts = found(wide_factors, patch_quarters.size(), slope_slacks)) return *std::move(charts);
    if (auto charts = found(patch_quarters.size() - 1, patch_quarters.size(), last_slacks)) return *std::move(charts);
    std::vector<std::vector<double>> places;
    for (const std::size_t label : failed_) places.push_back(place_of(label));
    throw TooCoarse(reason, std::move(places));
  }

 private:
  std::optional<Rational> fitting_slope(const Rational& patch, double slack, std::string& reason) {
    Rational slope;
    failed_.clear();
    if (!estimate(patch, slack, slope, reason)) return std::nullopt;
    std::vector<std::size_t> suspects = spread(most_suspects);
    while (slope <= Rational(1)) {
      auto failures = failing(suspects, patch, slope);
      if (failures.empty()) failures = failing(all_, patch, slope);
      if (failures.empty()) return slope;
      note(failures.front().first, failures.front().second.reason, reason);
      suspects.clear();
      failed_.clear();
      for (const auto& [label, failure] : failures) {
        failed_.push_back(label);
        suspects.push_back(label);
        if (failure.is_slope) continue;
        note(label, failure.reason, reason);
        return std::nullopt;
      }
      slope = rounded_up(slope * Rational(Integer(9), Integer(8)), slope_exponent);
    }
    return std::nullopt;
  }

  /// About so many labels, at most.
  [[nodiscard]] std::vector<std::size_t> spread(std::size_t most) const {
    std::vector<std::size_t> result;
    for (std::size_t at = 0; at < charts_.size(); at += charts_.size() / most + 1) result.push_back(at);
    return result;
  }

  /// A little more than the slope that all charts seem to need; false if it is above 1.
  bool estimate(const Rational& patch, double slack, Rational& slope, std::string& reason) {
    constexpr int rounds = 16;
    const std::vector<std::size_t> looked_at = spread(most_estimates);
    double needed = 0;
    for (int round = 0; round < rounds; ++round) {
      const double last = needed;
      std::size_t where = 0;
      in_parts(
          "estimate slopes", looked_at.size(), progress_,
          [&](std::size_t first, std::size_t end) {
            SlopeEstimate estimate(zero_set_);
            std::pair<double, std::size_t> most{0, looked_at[first]};
            for (std::size_t at = first; at < end; ++at) {
              const double radius = approximate_double(patch * radii_.of(looked_at[at]));
              const double found = slack * estimate.estimate(charts_[looked_at[at]], radius, last);
              if (found > most.first) most = {found, looked_at[at]};
            }
            return most;
          },
          [&](const std::pair<double, std::size_t>& found) {
            if (found.first > needed) {
              needed = found.first;
              where = found.second;
            }
          });
      if (!(needed <= 1)) {
        failed_.push_back(where);
        note(where, "its patch is steeper than 1", reason);
        return false;
      }
      if (needed <= last * 1.01) break;
    }
    slope = rounded_up(Rational::exactly(std::max(needed, 0x1p-8)), slope_exponent);
    return true;
  }

  std::vector<std::pair<std::size_t, GraphFailure>> failing(const std::vector<std::size_t>& labels,
                                                            const Rational& patch, const Rational& slope) {
    // Others may divide the cylinders otherwise.
    const Rational less = slope * (Rational(1) - Rational::power_of_two(-6));
    std::vector<std::pair<std::size_t, GraphFailure>> result;
    in_parts(
        "look at patches", labels.size(), progress_,
        [&](std::size_t first, std::size_t last) {
          GraphCheck check(zero_set_);
          std::vector<std::pair<std::size_t, GraphFailure>> found;
          for (std::size_t at = first; at < last; ++at) {
            TangentChart& chart = charts_[labels[at]];
            const Rational& unit = radii_.of(labels[at]);
            const Rational radius = patch * unit;
            const Rational least = least_height(radius, slope);
            std::vector high_lids{radius * Rational::power_of_two(-1), unit * Rational(Integer(13), Integer(8))};
            // Where they vary, discs of level 4 are larger, and lids have to be higher than these are wide.
            if (radii_.vary()) high_lids = {eighths(unit, 23), eighths(unit, 19), eighths(unit, 16), eighths(unit, 13)};
            chart.set_size(radius, least);
            if (auto failure = check.failure(chart, less)) {
              found.emplace_back(labels[at], std::move(*failure));
              continue;
            }
            // The higher, the fewer parts the box is divided into.
            for (const Rational& height : high_lids) {
              if (height <= least) break;
              chart.set_size(radius, height);
              if (check.may_be_as_high(chart)) break;
              chart.set_size(radius, least);
            }
          }
          return found;
        },
        [&](std::vector<std::pair<std::size_t, GraphFailure>> found) {
          result.insert(result.end(), found.begin(), found.end());
        });
    return result;
  }

  [[nodiscard]] std::vector<double> place_of(std::size_t label) const {
    std::vector<double> x;
    for (const Rational& coordinate : charts_[label].data().centre) x.push_back(approximate_double(coordinate));
    return x;
  }
  void note(std::size_t label, const std::string& what, std::string& reason) const {
    const std::vector<double> x = place_of(label);
    reason = zero_set_.description().name + ": label " + std::to_string(label) + " at " + rough_text(x) + ": " + what;
    const double advised = advised_radius(charts_[label], x);
    if (advised < approximate_double(radii_.of(label))) {
      char text[32];
      std::snprintf(text, sizeof text, "%.2g", advised);
      reason += ": there, by the curvature, a sampling radius of some " + std::string(text) + " would do";
    }
  }

  /// 1/(6κ), κ the norm of the second derivative of the graph at the centre: in doubles.
  double advised_radius(const TangentChart& chart, const std::vector<double>& x) const {
    const std::size_t n = zero_set_.ambient();
    const std::size_t m = zero_set_.dimension();
    const std::size_t q = n - m;
    FormulaEvaluation<double> f(zero_set_.map());
    std::vector<double> value(q);
    Dense<double> first(q * n);
    Dense<double> second(q * n * n);
    if (!f.second(x.data(), value.data(), first.data(), second.data())) return 0;
    const auto& enclosed = chart.enclosed();
    double squared = 0;
    for (std::size_t row = 0; row < q; ++row) {
      for (std::size_t k = 0; k < m; ++k) {
        for (std::size_t l = 0; l < m; ++l) {
          double entry = 0;
          for (std::size_t b = 0; b < q; ++b) {
            for (std::size_t a = 0; a < n; ++a) {
              for (std::size_t c = 0; c < n; ++c)
                entry += enclosed.preconditioner[row * q + b].lower() * second[(b * n + a) * n + c] *
                         enclosed.at(a, k).lower() * enclosed.at(c, l).lower();
            }
          }
          squared += entry * entry;
        }
      }
    }
    return 1 / (6 * std::sqrt(squared));
  }

  const ZeroSet& zero_set_;
  const SamplingRadii& radii_;
  const Progress& progress_;
  std::vector<TangentChart> charts_;
  std::vector<std::size_t> all_;
  std::vector<std::size_t> failed_;  // at what was last tried
};

}  // namespace

FittedCharts fit_charts(const ZeroSet& zero_set, const std::vector<std::vector<Rational>>& centres,
                        const SamplingRadii& radii, const Progress& progress) {
  if (radii.greatest() <= Rational(0)) throw InputError("the sampling radius is above 0");
  if (centres.empty()) throw InputError("a net has at least one point");
  return Fitting(zero_set, centres, radii, progress).fit();
}

Rational distortion_of_slope(const Rational& slope) {
  const Rational stretch = square_root_upper(Rational(1) + square(slope), 30) - Rational(1);
  return stretch <= Rational(0) ? Rational(0) : rounded_up(stretch, binary_exponent(stretch) - 10);
}

}  // namespace delcert
