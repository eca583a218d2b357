#include "kernel/perturb/grid_ball.hpp"

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// Fewer steps are doubles, with one bit to spare.
constexpr unsigned most_bits_of_few = 52;

}  // namespace

template <int m>
GridBall<m>::GridBall(const FrameMetric<m>& metric, const MetricOn<Filter, m>& enclosed,
                      const Vector<Rational, m>& centre, const Rational& radius, long exponent)
    : metric_(metric),
      enclosed_(enclosed),
      centre_(centre),
      squared_radius_(square(radius)),
      enclosed_squared_radius_(scalar_from<Filter>(squared_radius_)),
      step_(Rational::power_of_two(exponent)),
      enclosed_step_(scalar_from<Filter>(step_)) {
  for (std::size_t at = 0; at < m; ++at) {
    Axis& axis = axes_[at];
    const Rational half = square_root_upper(squared_radius_ * metric.inverse_diagonal(at), 32);
    const Integer first = floor_of((centre[at] - half) / step_);
    axis.count = ceiling_of((centre[at] + half) / step_) - first + 1;
    axis.bits = static_cast<unsigned>(msb(axis.count)) + 1;
    if (axis.bits <= most_bits_of_few) axis.few = axis.count.template convert_to<std::uint64_t>();
    axis.first = Rational(first) * step_;
    axis.from_zero = scalar_from<Filter>(axis.first);
    axis.from_centre = scalar_from<Filter>(axis.first - centre[at]);
  }
}

template <int m>
void GridBall<m>::draw(CounterRandom& random) {
  do {
    for (std::size_t at = 0; at < m; ++at) {
      choose(random, axes_[at]);
      const Filter along = length(axes_[at]);
      enclosure_[at] = axes_[at].from_zero + along;
      from_centre_[at] = axes_[at].from_centre + along;
    }
  } while (!is_in_ball());
}

template <int m>
void GridBall<m>::choose(CounterRandom& random, Axis& axis) {
  if (axis.few > 0) {
    do {
      axis.chosen = random.next_bits(axis.bits);
    } while (axis.chosen >= axis.few);
  } else {
    do {
      axis.chosen_of_many = random.next_integer(axis.bits);
    } while (axis.chosen_of_many >= axis.count);
  }
}

template <int m>
Filter GridBall<m>::length(const Axis& axis) const {
  if (axis.few > 0) return Filter::exactly(static_cast<double>(axis.chosen)) * enclosed_step_;
  return scalar_from<Filter>(Rational(axis.chosen_of_many) * step_);
}

template <int m>
bool GridBall<m>::is_in_ball() const {
  const Verdict verdict = less_equal(enclosed_.squared_norm(from_centre_), enclosed_squared_radius_);
  if (!is_undecided(verdict)) return is_proved(verdict);
  return metric_.template on<Rational>().squared_norm(difference(exact(), centre_)) <= squared_radius_;
}

template <int m>
Vector<Rational, m> GridBall<m>::exact() const {
  Vector<Rational, m> result;
  for (std::size_t at = 0; at < m; ++at) {
    const Axis& axis = axes_[at];
    result[at] = axis.first + (axis.few > 0 ? Rational(axis.chosen) : Rational(axis.chosen_of_many)) * step_;
  }
  return result;
}

#define DELCERT_INSTANTIATE(m) template class GridBall<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
