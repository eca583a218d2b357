#include "proofs/constants/sphere_sample_size.hpp"

#include <mpfr.h>

#include <utility>

namespace delcert {

namespace {

Rational pi_rounded(mpfr_rnd_t direction) {
  mpfr_t value;
  mpfr_init2(value, 256);
  mpfr_const_pi(value, direction);
  Rational::Wrapped result;
  mpfr_get_q(result.backend().data(), value);
  mpfr_clear(value);
  return Rational(std::move(result));
}

/// rational · π^power for a positive rational.
Bounds times_power_of_pi(const Rational& rational, long exponent) {
  return {rational * power(pi_rounded(MPFR_RNDD), exponent), rational * power(pi_rounded(MPFR_RNDU), exponent)};
}

/// Volume of the unit sphere of dimension m over the volume of the unit ball of ℝᵐ, without the factor π that it has
/// for odd m: 2 and π for m = 0 and 1, and from m to m + 2 it grows by the factor (m + 2)/(m + 1), as both volumes do
/// by factors of 2π/(m + 1) and 2π/(m + 2).
Rational sphere_over_ball_without_pi(int m) {
  Rational rational(m % 2 == 0 ? 2 : 1);
  for (int lower = m % 2; lower < m; lower += 2) rational *= Rational(lower + 2) / Rational(lower + 1);
  return rational;
}

/// Bounds of log2 π.
Bounds log2_of_pi() {
  const auto rounded = [](mpfr_rnd_t direction) {
    mpfr_t value;
    mpfr_init2(value, 256);
    mpfr_const_pi(value, direction);
    mpfr_log2(value, value, direction);
    Rational::Wrapped result;
    mpfr_get_q(result.backend().data(), value);
    mpfr_clear(value);
    return Rational(std::move(result));
  };
  return {rounded(MPFR_RNDD), rounded(MPFR_RNDU)};
}

/// Volume of the unit sphere times the measured number of net points per volume ε^m.
std::optional<Bounds> measured_density(int m) {
  if (m == 2) return times_power_of_pi(Rational(4) * Rational(697) / Rational(1000), 1);
  if (m == 3) return times_power_of_pi(Rational(2) * Rational(743) / Rational(1000), 2);
  return std::nullopt;
}

}  // namespace

SphereSampleSize sphere_sample_size(Dimension dimension, const PowerProduct& sampling_radius) {
  const int m = dimension.value;
  const PowerProduct number_of_cells = power(sampling_radius, -m);
  const Bounds cells = number_of_cells.bounds();
  const auto times_cells = [&](const Bounds& factor) {
    return Bounds{factor.lower * cells.lower, factor.upper * cells.upper};
  };
  const Rational over_ball = sphere_over_ball_without_pi(m);
  SphereSampleSize result;
  result.at_least = times_cells(times_power_of_pi(over_ball, m % 2));
  result.at_least_without_pi = PowerProduct(over_ball) * number_of_cells;
  result.has_factor_pi = m % 2 == 1;
  result.at_least_log2 = result.at_least_without_pi.log2();
  if (result.has_factor_pi) {
    const Bounds pi = log2_of_pi();
    result.at_least_log2.lower += pi.lower;
    result.at_least_log2.upper += pi.upper;
  }
  if (const auto density = measured_density(m)) result.measured_estimate = times_cells(*density);
  return result;
}

}  // namespace delcert
