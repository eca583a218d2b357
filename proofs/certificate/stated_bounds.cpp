#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {

namespace {

constexpr long slack_exponent = -20;

}  // namespace

Rational stated_below(const Rational& x, long digits) {
  const Rational weaker = x * (Rational(1) - Rational::power_of_two(slack_exponent));
  return rounded_down(weaker, binary_exponent(weaker) - digits + 1);
}
Rational stated_below(double x, long digits) { return stated_below(Rational::exactly(x), digits); }

Rational stated_above(const Rational& x, long digits) {
  const Rational weaker = x * (Rational(1) + Rational::power_of_two(slack_exponent));
  return rounded_up(weaker, binary_exponent(weaker) - digits + 1);
}
Rational stated_above(double x, long digits) { return stated_above(Rational::exactly(x), digits); }

}  // namespace delcert
