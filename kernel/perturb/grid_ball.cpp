#include "kernel/perturb/grid_ball.hpp"

#include <algorithm>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// Of a number of steps, so many bits are drawn into a double; the others only tell what is exactly meant.
constexpr unsigned head_bits = 52;

}  // namespace

template <int m>
GridBall<m>::GridBall(const FrameMetric<m>& metric, const MetricOn<Filter, m>& enclosed,
                      const Vector<Rational, m>& centre, const Rational& radius, long exponent)
    : metric_(metric), enclosed_(enclosed), exponent_(exponent), step_(Rational::power_of_two(exponent)) {
  take_radius(radius);
  take_centre(centre);
}

template <int m>
void GridBall<m>::move_to(const Vector<Rational, m>& centre, const Rational& radius) {
  // On quotients of model spaces all balls are the same.
  const bool is_same_radius = radius == radius_;
  if (is_same_radius && centre == centre_) return;
  if (!is_same_radius) take_radius(radius);
  take_centre(centre);
}

template <int m>
void GridBall<m>::take_radius(const Rational& radius) {
  radius_ = radius;
  squared_radius_ = square(radius);
  enclosed_squared_radius_ = scalar_from<Filter>(squared_radius_);
  for (std::size_t at = 0; at < m; ++at)
    halves_[at] = square_root_upper(squared_radius_ * metric_.inverse_diagonal(at), 32);
}

template <int m>
void GridBall<m>::take_centre(const Vector<Rational, m>& centre) {
  centre_ = centre;
  for (std::size_t at = 0; at < m; ++at) {
    Axis& axis = axes_[at];
    const Integer first = floor_of((centre[at] - halves_[at]) / step_);
    axis.count = ceiling_of((centre[at] + halves_[at]) / step_) - first + 1;
    axis.bits = static_cast<unsigned>(msb(axis.count)) + 1;
    axis.rest = axis.bits > head_bits ? axis.bits - head_bits : 0;
    axis.head_of_count = Integer(axis.count >> axis.rest).template convert_to<std::uint64_t>();
    axis.unit = scalar_from<Filter>(Rational::power_of_two(exponent_ + static_cast<long>(axis.rest)));
    axis.words.resize((axis.bits + 31) / 32);
    axis.first = Rational(first) * step_;
    axis.from_zero = scalar_from<Filter>(axis.first);
    axis.from_centre = scalar_from<Filter>(axis.first - centre[at]);
  }
}

template <int m>
void GridBall<m>::draw(CounterRandom& random) {
  while (true) {
    for (Axis& axis : axes_) choose(random, axis);
    const Verdict outside = is_clearly_outside();
    if (is_proved(outside)) continue;
    enclose();
    if (is_refuted(outside) || is_in_ball()) return;
  }
}

// Half of what is drawn from a cube is outside of its ball, and all but a few are clearly outside or inside: each of
// the few operations here is wrong by some 2⁻⁵² of the radius at most.
template <int m>
Verdict GridBall<m>::is_clearly_outside() const {
  constexpr double slack = 0x1p-30;
  if (!metric_.is_cartesian()) return Verdict::undecided;
  double squared = 0;
  for (const Axis& axis : axes_) {
    const double offset = axis.from_centre.lower() + static_cast<double>(axis.head) * axis.unit.lower();
    squared += offset * offset;
  }
  if (squared > enclosed_squared_radius_.upper() * (1 + slack)) return Verdict::proved;
  return squared < enclosed_squared_radius_.lower() * (1 - slack) ? Verdict::refuted : Verdict::undecided;
}

template <int m>
void GridBall<m>::enclose() {
  for (std::size_t at = 0; at < m; ++at) {
    const Filter along = length(axes_[at]);
    enclosure_[at] = axes_[at].from_zero + along;
    from_centre_[at] = axes_[at].from_centre + along;
  }
}

template <int m>
void GridBall<m>::choose(CounterRandom& random, Axis& axis) {
  do {
    for (std::uint32_t& word : axis.words) word = random.next_word();
    axis.words.back() >>= 32 * axis.words.size() - axis.bits;
    axis.head = head_of(axis);
  } while (axis.head > axis.head_of_count || (axis.head == axis.head_of_count && chosen(axis) >= axis.count));
}

template <int m>
std::uint64_t GridBall<m>::head_of(const Axis& axis) {
  // As usual; the same as below.
  if (axis.words.size() == 2) return (std::uint64_t{axis.words[0]} << (axis.bits - 32) | axis.words[1]) >> axis.rest;
  std::uint64_t head = 0;
  unsigned missing = std::min(axis.bits, head_bits);
  unsigned left = axis.bits;
  for (const std::uint32_t word : axis.words) {
    const unsigned taken = std::min(left, 32U);
    left -= taken;
    const unsigned used = std::min(missing, taken);
    missing -= used;
    if (used > 0) head = (head << used) | (word >> (taken - used));
  }
  return head;
}

template <int m>
Integer GridBall<m>::chosen(const Axis& axis) {
  Integer result = 0;
  unsigned left = axis.bits;
  for (const std::uint32_t word : axis.words) {
    const unsigned taken = std::min(left, 32U);
    left -= taken;
    result = (result << taken) + word;
  }
  return result;
}

template <int m>
Filter GridBall<m>::length(const Axis& axis) {
  const auto head = static_cast<double>(axis.head);
  return (axis.rest == 0 ? Filter::exactly(head) : Filter::between(head, head + 1)) * axis.unit;
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
    result[at] = axis.first + Rational(chosen(axis)) * step_;
  }
  return result;
}

#define DELCERT_INSTANTIATE(m) template class GridBall<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
