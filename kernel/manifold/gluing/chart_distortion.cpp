#include "kernel/manifold/gluing/chart_distortion.hpp"

#include "kernel/manifold/gluing/growing_bound.hpp"

namespace delcert {

namespace {

/// Patches are covered by so many boxes along each axis.
template <int m>
constexpr int pieces = m == 2 ? 4 : 2;

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
    return {rounding_.rounded(), all_are_same_ ? Rational(0) : transition_.rounded(), metric_.rounded()};
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
  GrowingBound rounding_;
  GrowingBound transition_;
  GrowingBound metric_;
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
  return fitted_patches<m>(atlas, atlas.field().description().name, Rational::power_of_two(-1),
                           [&](const Rational& limit) { return measure_distortion<m>(atlas, limit, progress); });
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
