#include "kernel/manifold/gluing/chart_distortion.hpp"

#include <string>

#include "support/error.hpp"

namespace delcert {

namespace {

/// Patches are covered by so many boxes along each axis.
template <int m>
constexpr int pieces = m == 2 ? 4 : 2;

/// A bound that grows until it suffices, or reaches the limit.
class Bound {
 public:
  explicit Bound(double limit) : limit_(limit) {}
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] bool is_below_limit() const { return value_ < limit_; }

  template <class Suffices>
  void grow_until(const Suffices& suffices) {
    while (is_below_limit() && !is_proved(suffices(Interval::exactly(value_)))) value_ += value_ / 32;
  }

 private:
  double limit_;
  double value_ = 0x1p-40;
};

/// (1 − a)² b < x < (1 + a)² b.
template <std::size_t m>
Verdict is_within(const std::array<std::array<Interval, m>, m>& x, const Interval& a,
                  const std::array<std::array<Interval, m>, m>& b) {
  return conjunction(is_above(x, square(Interval(1) - a), b), is_below(x, square(Interval(1) + a), b));
}

Rational with_few_digits(double bound) {
  const Rational exact = Rational::exactly(bound);
  return rounded_up(exact, binary_exponent(exact) - 11);
}

template <int m>
class Measurement {
 public:
  Measurement(const MetricFieldAtlas<m>& atlas, double limit)
      : atlas_(atlas),
        all_are_same_(atlas.field().is_constant()),
        radius_(atlas.patch_radius()),
        rounding_(limit),
        transition_(limit),
        metric_(limit) {}

  /// Whether all bounds are below the limit.
  bool look_at(Label i) {
    const RoundingGuard guard;
    const auto& gram = atlas_.enclosed_gram(i);
    const auto exact = atlas_.field().template at<Interval>(atlas_.centre(i));
    rounding_.grow_until([&](const Interval& eta) {
      return conjunction(is_above(gram, Interval(1) - eta, exact), is_below(gram, Interval(1) + eta, exact));
    });
    look_at_patch(i);
    if (!rounding_.is_below_limit() || !metric_.is_below_limit()) return false;
    if (all_are_same_) return true;
    atlas_.sightings(i, scalar_from<Interval>(radius_).upper(), seen_);
    for (const auto& other : seen_) {
      if (other.index == i.value) continue;
      transition_.grow_until(
          [&](const Interval& xi) { return is_within(atlas_.enclosed_gram(Label(other.index)), xi, gram); });
    }
    return transition_.is_below_limit();
  }

  [[nodiscard]] ChartDistortion result() const {
    return {with_few_digits(rounding_.value()), all_are_same_ ? Rational(0) : with_few_digits(transition_.value()),
            with_few_digits(metric_.value())};
  }

 private:
  /// The box |x_k − p_k| ≤ ϱ√(B⁻¹)_kk in pieces.
  void look_at_patch(Label i) {
    Vector<Rational, m> half_widths;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const Interval stretch = square_root(scalar_from<Interval>(atlas_.chart(i).squared_stretch(axis)));
      half_widths[axis] = radius_ * Rational::exactly(stretch.upper()) / Rational(pieces<m>);
    }
    std::array<int, static_cast<std::size_t>(m)> piece{};
    for (bool more = true; more;) {
      Vector<Rational, m> middle = atlas_.centre(i);
      for (std::size_t axis = 0; axis < m; ++axis)
        middle[axis] += Rational(2 * piece[axis] + 1 - pieces<m>) * half_widths[axis];
      const auto values = atlas_.field().within(middle, half_widths);
      metric_.grow_until([&](const Interval& kappa) { return is_within(values, kappa, atlas_.enclosed_gram(i)); });
      more = false;
      for (std::size_t axis = 0; axis < m && !more; ++axis) {
        more = ++piece[axis] < pieces<m>;
        if (!more) piece[axis] = 0;
      }
    }
  }

  const MetricFieldAtlas<m>& atlas_;
  bool all_are_same_;
  Rational radius_;
  Bound rounding_;
  Bound transition_;
  Bound metric_;
  std::vector<Sighting<m>> seen_;
};

}  // namespace

template <int m>
std::optional<ChartDistortion> measure_distortion(const MetricFieldAtlas<m>& atlas, const Rational& limit,
                                                  const Progress& progress) {
  Measurement<m> measurement(atlas, approximate_double(limit));
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    if (index % 256 == 0) progress("measure the distortion", index, atlas.size());
    if (!measurement.look_at(Label(index))) return std::nullopt;
  }
  return measurement.result();
}

template <int m>
ChartDistortion fit_patches(MetricFieldAtlas<m>& atlas, const Progress& progress) {
  while (true) {
    const bool is_least = atlas.patch_factor() == MetricFieldAtlas<m>::least_patch_factor;
    const Rational limit = Rational::power_of_two(is_least ? -1 : -2);
    if (const auto result = measure_distortion<m>(atlas, limit, progress)) return *result;
    if (is_least)
      throw Rejection(atlas.field().description().name + ": charts are distorted by 1/2 or more within " +
                      std::to_string(MetricFieldAtlas<m>::least_patch_factor) +
                      " sampling radii: take a smaller radius");
    atlas.shrink_patches(atlas.patch_factor() - 1);
  }
}

Rational relative_stretch(const ChartDistortion& distortion) {
  return (Rational(1) + distortion.metric) / (Rational(1) - distortion.metric) - Rational(1);
}

#define DELCERT_INSTANTIATE(m)                                                                               \
  template std::optional<ChartDistortion> measure_distortion<m>(const MetricFieldAtlas<m>&, const Rational&, \
                                                                const Progress&);                            \
  template ChartDistortion fit_patches<m>(MetricFieldAtlas<m>&, const Progress&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
