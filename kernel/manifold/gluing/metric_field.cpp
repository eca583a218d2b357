#include "kernel/manifold/gluing/metric_field.hpp"

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/simple_fraction.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Boxes to look at: for what has to be known, and for what may as well be known less well.
constexpr std::size_t all_boxes = std::size_t{1} << 18;
constexpr std::size_t few_boxes = std::size_t{1} << 13;
/// Bounds of eigenvalues have so many binary digits.
constexpr int bound_digits = 5;

void require_symmetric(const MetricFieldDescription::Square& matrix, std::size_t size, const std::string& what) {
  bool fits = matrix.size() == size;
  for (const auto& row : matrix) fits = fits && row.size() == size;
  if (!fits) throw InputError(what + " is not a matrix of " + std::to_string(size) + " rows of as many numbers");
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < row; ++column) {
      if (matrix[row][column] != matrix[column][row])
        throw InputError(what + " is not symmetric: rows " + std::to_string(column + 1) + " and " +
                         std::to_string(row + 1));
    }
  }
}

template <int m>
Matrix<Interval, m> identity() {
  Matrix<Interval, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis][axis] = Interval(1);
  return result;
}

}  // namespace

template <int m>
MetricField<m>::MetricField(MetricFieldDescription description) : description_(std::move(description)) {
  const auto size = static_cast<std::size_t>(m);
  if (description_.dimension != Dimension(m))
    throw InputError(description_.name + ": a metric field of dimension " + std::to_string(m) + " is expected");
  require_symmetric(description_.constant, size, "the constant term");
  for (std::size_t at = 0; at < description_.waves.size(); ++at) {
    const auto& wave = description_.waves[at];
    const std::string what = "of wave " + std::to_string(at + 1);
    if (wave.frequency.size() != size) throw InputError("the frequency " + what + " is not a vector of the dimension");
    require_symmetric(wave.cosine, size, "the cosine matrix " + what);
    require_symmetric(wave.sine, size, "the sine matrix " + what);
  }
  find_bounds();
}

template <int m>
template <class S, class WaveOf>
Matrix<S, m> MetricField<m>::summed(const WaveOf& wave_of) const {
  Matrix<S, m> result;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column)
      result[row][column] = scalar_from<S>(description_.constant[row][column]);
  }
  for (const auto& term : description_.waves) {
    const Wave<S> wave = wave_of(term.frequency);
    for (std::size_t row = 0; row < m; ++row) {
      for (std::size_t column = 0; column < m; ++column) {
        const Rational& cosine = term.cosine[row][column];
        const Rational& sine = term.sine[row][column];
        if (cosine != Rational(0)) result[row][column] += scalar_from<S>(cosine) * wave.cosine;
        if (sine != Rational(0)) result[row][column] += scalar_from<S>(sine) * wave.sine;
      }
    }
  }
  return result;
}

template <int m>
template <class S>
Matrix<S, m> MetricField<m>::at(const Vector<Rational, m>& x) const {
  return summed<S>([&x](const std::vector<int>& frequency) {
    Rational t(0);
    for (std::size_t axis = 0; axis < m; ++axis) t += Rational(frequency[axis]) * x[axis];
    return wave_at<S>(t);
  });
}

template <int m>
Matrix<Interval, m> MetricField<m>::within(const Vector<Rational, m>& x, const Vector<Rational, m>& half_widths) const {
  return summed<Interval>([&](const std::vector<int>& frequency) {
    Rational middle(0);
    Rational half_width(0);
    for (std::size_t axis = 0; axis < m; ++axis) {
      middle += Rational(frequency[axis]) * x[axis];
      half_width += Rational(std::abs(frequency[axis])) * half_widths[axis];
    }
    return wave_within(middle, half_width);
  });
}

/// By boxes that are halved where enclosures do not tell; false as well where the budget does not suffice.
template <int m>
template <class Holds>
bool MetricField<m>::holds_everywhere(std::size_t most_boxes, const Holds& holds) const {
  struct Box {
    Vector<Rational, m> middle;
    Vector<Rational, m> half_widths;
    std::size_t next_axis = 0;
  };
  const Rational half = Rational::power_of_two(-1);
  Box whole;
  whole.middle.fill(half);
  whole.half_widths.fill(is_constant() ? Rational(0) : half);
  std::vector<Box> open{whole};
  for (std::size_t looked_at = 0; !open.empty(); ++looked_at) {
    if (looked_at == most_boxes) return false;
    const Box box = std::move(open.back());
    open.pop_back();
    const Verdict verdict = holds(within(box.middle, box.half_widths));
    if (is_proved(verdict)) continue;
    if (is_refuted(verdict) || is_refuted(holds(at<Interval>(box.middle)))) return false;
    for (const int side : {-1, 1}) {
      Box part = box;
      part.half_widths[box.next_axis] *= half;
      part.middle[box.next_axis] += Rational(side) * part.half_widths[box.next_axis];
      part.next_axis = (box.next_axis + 1) % m;
      open.push_back(std::move(part));
    }
  }
  return true;
}

template <int m>
bool MetricField<m>::exceeds(const Rational& bound, std::size_t most_boxes) const {
  const Interval factor = scalar_from<Interval>(bound);
  return holds_everywhere(most_boxes, [&](const Matrix<Interval, m>& g) { return is_above(g, factor, identity<m>()); });
}

template <int m>
bool MetricField<m>::stays_below(const Rational& bound, std::size_t most_boxes) const {
  const Interval factor = scalar_from<Interval>(bound);
  return holds_everywhere(most_boxes, [&](const Matrix<Interval, m>& g) { return is_below(g, factor, identity<m>()); });
}

template <int m>
void MetricField<m>::find_bounds() {
  const RoundingGuard guard;
  if (!exceeds(Rational(0), all_boxes))
    throw Rejection(description_.name + ": the metric is not certainly positive definite everywhere");
  // Doubling and halving, then bisection: the answers decide by themselves, whatever is tried.
  Rational upper(1);
  while (!stays_below(upper, all_boxes)) upper *= Rational(2);
  Rational low = upper * Rational::power_of_two(-1);
  for (int digit = 0; digit < bound_digits; ++digit) {
    const Rational middle = (low + upper) * Rational::power_of_two(-1);
    (stays_below(middle, few_boxes) ? upper : low) = middle;
  }
  Rational lower = upper;
  while (!exceeds(lower, all_boxes)) lower *= Rational::power_of_two(-1);
  Rational high = lower * Rational(2);
  for (int digit = 0; digit < bound_digits; ++digit) {
    const Rational middle = (lower + high) * Rational::power_of_two(-1);
    (exceeds(middle, few_boxes) ? lower : high) = middle;
  }
  bounds_ = {lower, upper};
}

Rational fitting_sampling_radius(const EigenvalueBounds& bounds) {
  // 3·4ε√(B⁻¹)_kk < 1, where B is the metric at a point up to a relative 10⁻⁸; simple fractions stay farther away.
  const Rational relative_rounding = Rational::power_of_two(-20);
  return simple_fraction_below(square_root_lower(bounds.lower, 40) * (Rational(1) - relative_rounding) / Rational(12));
}

#define DELCERT_INSTANTIATE(m)                                                                 \
  template class MetricField<m>;                                                               \
  template Matrix<Interval, m> MetricField<m>::at<Interval>(const Vector<Rational, m>&) const; \
  template Matrix<BigInterval, m> MetricField<m>::at<BigInterval>(const Vector<Rational, m>&) const;
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
