#include "kernel/manifold/submanifold/singular_search.hpp"

#include <algorithm>
#include <deque>

#include "kernel/number/middle.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

namespace {

/// What is decided on one part.
class RegularParts {
 public:
  explicit RegularParts(const ZeroSet& zero_set)
      : n_(zero_set.ambient()),
        q_(zero_set.codimension()),
        f_(zero_set.map()),
        x_(n_),
        middle_(n_),
        value_(q_),
        central_value_(q_),
        derivative_(q_ * n_) {}

  /// Whether some equation certainly does not hold, or the derivatives are certainly independent.
  bool are_without_singular_points(const BoxPart& part) {
    for (std::size_t axis = 0; axis < n_; ++axis) {
      x_[axis] = Interval::between(part.lower[axis], part.upper[axis]);
      middle_[axis] = Interval::exactly(middle_of(x_[axis]));
    }
    if (!f_.first(x_.data(), value_.data(), derivative_.data())) return false;
    if (std::any_of(value_.begin(), value_.end(), is_away_from_zero)) return true;
    if (f_.value(middle_.data(), central_value_.data())) {
      for (std::size_t row = 0; row < q_; ++row) {
        Interval sum = central_value_[row];
        for (std::size_t axis = 0; axis < n_; ++axis) sum += derivative_[row * n_ + axis] * (x_[axis] - middle_[axis]);
        if (is_away_from_zero(sum)) return true;
      }
    }
    return is_of_full_rank();
  }

 private:
  static bool is_away_from_zero(const Interval& x) { return x.lower() > 0 || x.upper() < 0; }

  /// By ‖1 − J·W‖ < 1 for all J of the part, W the pseudo-inverse of one of them.
  [[nodiscard]] bool is_of_full_rank() const {
    Dense<double> rough;
    for (const Interval& entry : derivative_) rough.push_back(middle_of(entry));
    Dense<double> gram(q_ * q_, 0);
    for (std::size_t a = 0; a < q_; ++a) {
      for (std::size_t b = 0; b < q_; ++b) {
        for (std::size_t axis = 0; axis < n_; ++axis) gram[a * q_ + b] += rough[a * n_ + axis] * rough[b * n_ + axis];
      }
    }
    const auto inverse = inverse_of(std::move(gram), q_);
    if (!inverse) return false;
    Interval squared(0);
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t column = 0; column < q_; ++column) {
        Interval entry(row == column ? 1 : 0);
        for (std::size_t axis = 0; axis < n_; ++axis) {
          double weight = 0;
          for (std::size_t b = 0; b < q_; ++b) weight += rough[b * n_ + axis] * (*inverse)[b * q_ + column];
          if (!(std::fabs(weight) < 0x1p+500)) return false;
          entry -= derivative_[row * n_ + axis] * Interval::exactly(weight);
        }
        squared += square(entry);
      }
    }
    return squared.upper() < 1;
  }

  std::size_t n_, q_;
  FormulaEvaluation<Interval> f_;
  std::vector<Interval> x_, middle_, value_, central_value_, derivative_;
};

std::size_t widest_side(const BoxPart& part) {
  std::size_t result = 0;
  for (std::size_t axis = 1; axis < part.lower.size(); ++axis) {
    if (part.upper[axis] - part.lower[axis] > part.upper[result] - part.lower[result]) result = axis;
  }
  return result;
}

}  // namespace

std::optional<BoxPart> find_singular_part(const ZeroSet& zero_set, std::uint64_t most_parts) {
  const RoundingGuard guard;
  RegularParts regular(zero_set);
  BoxPart whole;
  for (const auto& [from, to] : zero_set.description().box) {
    whole.lower.push_back(scalar_from<Interval>(from).lower());
    whole.upper.push_back(scalar_from<Interval>(to).upper());
  }
  const std::size_t widest = widest_side(whole);
  const double least = (whole.upper[widest] - whole.lower[widest]) * 0x1p-16;
  std::deque<BoxPart> open(1, whole);
  for (std::uint64_t parts = 0; !open.empty() && parts < most_parts; ++parts) {
    // Breadth first, and in the end depth first: into one of many parts that may be singular.
    const bool is_deep = parts > most_parts / 2;
    const BoxPart part = std::move(is_deep ? open.back() : open.front());
    if (is_deep) {
      open.pop_back();
    } else {
      open.pop_front();
    }
    if (regular.are_without_singular_points(part)) continue;
    const std::size_t axis = widest_side(part);
    if (part.upper[axis] - part.lower[axis] <= least) return part;
    const double cut = part.lower[axis] / 2 + part.upper[axis] / 2;
    open.push_back(part);
    open.back().upper[axis] = cut;
    open.push_back(part);
    open.back().lower[axis] = cut;
  }
  return std::nullopt;
}

}  // namespace delcert
