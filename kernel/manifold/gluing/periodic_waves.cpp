#include "kernel/manifold/gluing/periodic_waves.hpp"

namespace delcert {

namespace {

Interval within_unit(const Interval& x) {
  return Interval::between(x.lower() > -1 ? x.lower() : -1, x.upper() < 1 ? x.upper() : 1);
}

}  // namespace

template <class S>
Wave<S> wave_at(const Rational& t) {
  const Integer quarters = floor_of(Rational(4) * t);
  const Rational rest = t - Rational(quarters) / Rational(4);
  Wave<S> first{S(1), S(0)};
  if (rest != Rational(0)) {
    const S angle = S(2) * straight_angle<S>() * scalar_from<S>(rest);
    const S squared = square(angle);
    first = {cosine_of_root(Curvature::positive, squared), angle * sine_ratio(Curvature::positive, squared)};
  }
  const Integer turn = quarters - 4 * floor_of(Rational(quarters) / Rational(4));
  switch (turn.convert_to<int>()) {
    case 0:
      return first;
    case 1:
      return {-first.sine, first.cosine};
    case 2:
      return {-first.cosine, -first.sine};
    default:
      return {first.sine, -first.cosine};
  }
}

template Wave<Interval> wave_at<Interval>(const Rational&);
template Wave<BigInterval> wave_at<BigInterval>(const Rational&);

Wave<Interval> wave_within(const Rational& middle, const Rational& half_width) {
  const Wave<Interval> at = wave_at<Interval>(middle);
  // cos(a + b) = cos a cos b − sin a sin b with |b| ≤ h: cos b ∈ [1 − h²/2, 1], |sin b| ≤ h.
  const Interval h = Interval(2) * straight_angle<Interval>() * scalar_from<Interval>(half_width);
  const Interval lost = square(h) / Interval(2);
  const Interval cosine = Interval::between(lost.upper() < 2 ? (Interval(1) - lost).lower() : -1, 1);
  const Interval sine = within_unit(Interval::between(-h.upper(), h.upper()));
  return {within_unit(at.cosine * cosine - at.sine * sine), within_unit(at.sine * cosine + at.cosine * sine)};
}

}  // namespace delcert
