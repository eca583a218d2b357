#include "kernel/manifold/submanifold/graph_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/manifold/submanifold/fibre_zero.hpp"
#include "kernel/manifold/submanifold/spectral_norm.hpp"
#include "kernel/number/rounding_guard.hpp"

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

}  // namespace delcert
