#include "kernel/manifold/submanifold/fibre_zero.hpp"

#include "kernel/number/elementary.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

namespace {

double middle(const Interval& x) { return x.lower() + (x.upper() - x.lower()) / 2; }
double middle(const BigInterval& x) { return approximate_double(x.lower()); }
/// One number of the enclosure.
Interval thinned(const Interval& x) { return Interval::exactly(middle(x)); }
BigInterval thinned(const BigInterval& x) { return lower_end(x); }
template <class S>
S exact_scalar(double x) {
  if constexpr (std::same_as<S, Interval>) {
    return Interval::exactly(x);
  } else {
    return BigInterval(Rational::exactly(x));
  }
}
Interval greatest_of(const Interval& x) { return Interval::exactly(x.upper()); }
BigInterval greatest_of(const BigInterval& x) { return upper_end(x); }
bool is_usable(const Interval& x) {
  return x.lower() > -std::numeric_limits<double>::max() && x.upper() < std::numeric_limits<double>::max();
}
bool is_usable(const BigInterval& x) { return x.is_bounded(); }
Interval unit_interval(const Interval&) { return Interval::between(-1, 1); }
BigInterval unit_interval(const BigInterval&) { return BigInterval::between(Rational(-1), Rational(1)); }

template <class S>
class FibreSearch {
 public:
  FibreSearch(FormulaEvaluation<S>& f, const EnclosedChart<S>& chart, const S* y)
      : f_(f),
        chart_(chart),
        n_(chart.ambient()),
        q_(chart.codimension()),
        place_(y, y + chart.dimension),
        x_(n_),
        value_(q_),
        derivative_(q_ * n_) {
    place_.resize(n_, S(0));
  }

  std::optional<std::vector<S>> run() {
    if (!newton()) return std::nullopt;
    // What Newton's method would still change, and a little more.
    S radius = S(0);
    for (const S& step : step_) radius = maximum(radius, greatest_of(absolute(step)));
    radius = greatest_of(twice(radius) + least_radius());
    const std::vector<S> middle_heights(place_.begin() + static_cast<std::ptrdiff_t>(chart_.dimension), place_.end());
    constexpr int most_tries = 4;
    for (int tries = 0; tries < most_tries; ++tries) {
      const S around = radius * unit_interval(radius);
      for (std::size_t b = 0; b < q_; ++b) place_[chart_.dimension + b] = middle_heights[b] + around;
      if (!evaluate()) return std::nullopt;
      // −Y'f(z) + (1 − Y'JN)(Z − z).
      bool is_inside = true;
      std::vector<S> result;
      for (std::size_t row = 0; row < q_; ++row) {
        S moved = -step_[row];
        for (std::size_t column = 0; column < q_; ++column) {
          S entry = row == column ? S(1) : S(0);
          for (std::size_t b = 0; b < q_; ++b) entry -= inverse_[row * q_ + b] * normal_[b * q_ + column];
          moved += entry * around;
        }
        if (!is_usable(moved) || !is_proved(less(absolute(moved), radius))) is_inside = false;
        result.push_back(middle_heights[row] + moved);
      }
      if (is_inside) return result;
      radius = greatest_of(S(4) * radius);
    }
    return std::nullopt;
  }

 private:
  static S least_radius() {
    if constexpr (std::same_as<S, Interval>) {
      return Interval::exactly(0x1p-60);
    } else {
      return BigInterval(Rational::power_of_two(-static_cast<long>(BigInterval::working_precision().value)));
    }
  }

  /// f, Df and Df·N at the place.
  bool evaluate() {
    chart_.position(place_.data(), x_.data());
    if (!f_.first(x_.data(), value_.data(), derivative_.data())) return false;
    normal_.assign(q_ * q_, S(0));
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t column = 0; column < q_; ++column) {
        for (std::size_t axis = 0; axis < n_; ++axis)
          normal_[row * q_ + column] += derivative_[row * n_ + axis] * chart_.at(axis, chart_.dimension + column);
        if (!is_usable(normal_[row * q_ + column])) return false;
      }
      if (!is_usable(value_[row])) return false;
    }
    return true;
  }

  /// Leaves heights, an approximate inverse there, and what the next step would be, enclosed.
  bool newton() {
    constexpr int most_steps = 200;
    S last = S(0);
    for (int step = 0; step < most_steps; ++step) {
      if (!evaluate()) return false;
      Dense<double> plain(q_ * q_);
      for (std::size_t at = 0; at < q_ * q_; ++at) plain[at] = middle(normal_[at]);
      const auto inverse = inverse_of(std::move(plain), q_);
      if (!inverse) return false;
      inverse_.clear();
      for (const double entry : *inverse) {
        if (!(std::fabs(entry) < std::numeric_limits<double>::max())) return false;
        inverse_.push_back(exact_scalar<S>(entry));
      }
      step_.assign(q_, S(0));
      S size = S(0);
      for (std::size_t row = 0; row < q_; ++row) {
        for (std::size_t b = 0; b < q_; ++b) step_[row] += inverse_[row * q_ + b] * value_[b];
        if (!is_usable(step_[row])) return false;
        size = maximum(size, greatest_of(absolute(step_[row])));
      }
      // Steps that do not become much shorter any more are rounding.
      if (step > 2 && !is_proved(less(S(4) * size, last))) return true;
      last = size;
      for (std::size_t row = 0; row < q_; ++row) {
        S& height = place_[chart_.dimension + row];
        height = thinned(height - thinned(step_[row]));
      }
    }
    return false;
  }

  FormulaEvaluation<S>& f_;
  const EnclosedChart<S>& chart_;
  std::size_t n_;
  std::size_t q_;
  std::vector<S> place_;
  std::vector<S> x_;
  std::vector<S> value_;
  Dense<S> derivative_;
  Dense<S> normal_;
  Dense<S> inverse_;
  std::vector<S> step_;
};

}  // namespace

template <class S>
std::optional<std::vector<S>> zero_on_fibre(FormulaEvaluation<S>& f, const EnclosedChart<S>& chart, const S* y) {
  return FibreSearch<S>(f, chart, y).run();
}
template std::optional<std::vector<Interval>> zero_on_fibre(FormulaEvaluation<Interval>&,
                                                            const EnclosedChart<Interval>&, const Interval*);
template std::optional<std::vector<BigInterval>> zero_on_fibre(FormulaEvaluation<BigInterval>&,
                                                               const EnclosedChart<BigInterval>&, const BigInterval*);

}  // namespace delcert
