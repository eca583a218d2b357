#include "kernel/number/simple_fraction.hpp"

namespace delcert {

namespace {

/// The fraction with the least denominator in [lower, upper). Precondition: 0 <= lower < upper.
Rational simplest_between(const Rational& lower, const Rational& upper) {
  const Rational whole(ceiling_of(lower));
  if (whole < upper) return whole;
  // No integer lies in between: the parts above floor(lower) are in (0, 1], and inverting them turns the ends round.
  const Rational below(floor_of(lower));
  const Rational first = Rational(1) / (upper - below);
  const Rational last = Rational(1) / (lower - below);
  // [lower, upper) has become (first, last].
  const Rational base(floor_of(first));
  if (base + Rational(1) <= last) return below + Rational(1) / (base + Rational(1));
  // Once more: [1/(last − base), 1/(first − base)), without an upper end if first is an integer.
  const Rational least = Rational(1) / (last - base);
  const Rational rest =
      first == base ? Rational(ceiling_of(least)) : simplest_between(least, Rational(1) / (first - base));
  return below + Rational(1) / (base + Rational(1) / rest);
}

}  // namespace

Rational simple_fraction_below(const Rational& x) { return simplest_between(x - x / Rational(64), x); }

Rational simple_fraction_at_most(const Rational& x) {
  const Rational below = simple_fraction_below(x);
  return x.denominator() <= below.denominator() ? x : below;
}

}  // namespace delcert
