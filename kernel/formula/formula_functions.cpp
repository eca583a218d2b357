#include "kernel/formula/formula_functions.hpp"

#include <cmath>

#include "kernel/chart/curved_functions.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert {

namespace {

// Up to here the multiples of what is taken away are exact in doubles, and what is left loses no more than some 40
// digits of 100.
constexpr double greatest_reduced = 0x1p20;
// Within which exponentials are far from overflow and underflow.
constexpr double greatest_exponential = 600;

/// A positive number as a sum of doubles of 30 digits, whose products with small integers are exact, and a rest.
struct Split {
  double first;
  double second;
  Interval rest;
};

Split split_of(const BigInterval& x) {
  const auto leading = [](const Rational& value) { return rounded_down(value, binary_exponent(value) - 29); };
  const Rational first = leading(x.lower());
  const Rational second = leading(x.lower() - first);
  return {approximate_double(first), approximate_double(second),
          in_doubles(x - BigInterval(first) - BigInterval(second))};
}

/// x − k·step.
Interval reduced(double x, double k, const Split& step) {
  return (Interval::exactly(x) - Interval::exactly(k * step.first) - Interval::exactly(k * step.second)) -
         Interval::exactly(k) * step.rest;
}

const Split& quarter_turn() {
  static const Split split = split_of(half_turn() / BigInterval(2));
  return split;
}

const Split& logarithm_of_two() {
  static const Split split = split_of(natural_logarithm_of_two());
  return split;
}

/// A whole number near x, whatever the rounding mode.
double near_integer(double x) { return static_cast<double>(static_cast<long>(x < 0 ? x - 0.5 : x + 0.5)); }

Interval exponential_at(double x) {
  if (!(std::fabs(x) <= greatest_exponential)) return in_doubles(exponential(in_big(Interval::exactly(x))));
  const double k = near_integer(x * 0x1.71547652b82fep0);
  const Interval rest = reduced(x, k, logarithm_of_two());
  const Interval squared = square(rest);
  const Interval value = cosine_of_root(Curvature::negative, squared) + rest * sine_ratio(Curvature::negative, squared);
  return value * Interval::exactly(std::ldexp(1.0, static_cast<int>(k)));
}

/// sin(x + turns·π/2).
Interval sine_at(double x, long turns) {
  if (!(std::fabs(x) <= greatest_reduced)) {
    const BigInterval big = in_big(Interval::exactly(x));
    const BigInterval value = turns % 2 == 0 ? sine(big) : cosine(big);
    return in_doubles(turns < 2 ? value : -value);
  }
  const double k = near_integer(x * 0x1.45f306dc9c883p-1);
  const Interval rest = reduced(x, k, quarter_turn());
  const Interval squared = square(rest);
  const long turn = (static_cast<long>(k) + turns) & 3;
  const Interval value =
      turn % 2 == 0 ? rest * sine_ratio(Curvature::positive, squared) : cosine_of_root(Curvature::positive, squared);
  return turn < 2 ? value : -value;
}

/// Whether x has an element that differs from `turns`·π/2 by a multiple of 2π; yes where that is not sure.
bool may_meet(const Interval& x, int turns) {
  const Interval quarter = straight_angle<Interval>() / Interval(2);
  const Interval places = (x / quarter - Interval(turns)) / Interval(4);
  return std::floor(places.upper()) >= std::ceil(places.lower());
}

/// The sine of x + turns·π/2, turns 0 or 1.
Interval shifted_sine(const Interval& x, int turns) {
  if (!(x.upper() - x.lower() < 6)) return Interval::between(-1, 1);
  const Interval low = sine_at(x.lower(), turns);
  const Interval high = sine_at(x.upper(), turns);
  const double lower = may_meet(x, 3 - turns) ? -1 : std::fmin(low.lower(), high.lower());
  const double upper = may_meet(x, 1 - turns) ? 1 : std::fmax(low.upper(), high.upper());
  return Interval::between(std::fmax(lower, -1), std::fmin(upper, 1));
}

// These have no arithmetic of their own where they switch the mode.
[[gnu::noinline]] double lower_exponential(double x) { return exponential(Interval::exactly(x)).lower(); }
[[gnu::noinline]] double lower_sine(double x) { return sine(Interval::exactly(x)).lower(); }
[[gnu::noinline]] double lower_cosine(double x) { return cosine(Interval::exactly(x)).lower(); }

template <class S>
S multiplied(const S& x, unsigned exponent) {
  if (exponent == 1) return x;
  const S half = multiplied(x, exponent / 2);
  const S even = half * half;
  return exponent % 2 == 0 ? even : even * x;
}

}  // namespace

Interval exponential(const Interval& x) {
  return Interval::between(exponential_at(x.lower()).lower(), exponential_at(x.upper()).upper());
}

Interval sine(const Interval& x) { return shifted_sine(x, 0); }
Interval cosine(const Interval& x) { return shifted_sine(x, 1); }

double approximate_exponential(double x) {
  const RoundingGuard guard;
  return lower_exponential(x);
}

double approximate_sine(double x) {
  const RoundingGuard guard;
  return lower_sine(x);
}

double approximate_cosine(double x) {
  const RoundingGuard guard;
  return lower_cosine(x);
}

double whole_power(double x, unsigned exponent) { return multiplied(x, exponent); }

Interval whole_power(const Interval& x, unsigned exponent) {
  if (exponent == 2) return square(x);
  if (exponent % 2 == 0) return multiplied(square(x), exponent / 2);
  // Products of an interval of one sign with itself are its powers.
  if (x.lower() >= 0 || x.upper() <= 0) return multiplied(x, exponent);
  return Interval::between(multiplied(Interval::exactly(x.lower()), exponent).lower(),
                           multiplied(Interval::exactly(x.upper()), exponent).upper());
}

BigInterval whole_power(const BigInterval& x, unsigned exponent) {
  if (exponent == 2) return square(x);
  if (exponent % 2 == 0) return multiplied(square(x), exponent / 2);
  return hull(multiplied(lower_end(x), exponent), multiplied(upper_end(x), exponent));
}

}  // namespace delcert
