#include "proofs/constants/sphere_sample_size.hpp"

#include <mpfr.h>

#include <utility>

namespace delcert {

namespace {

Rational pi_rounded(mpfr_rnd_t direction) {
  mpfr_t value;
  mpfr_init2(value, 128);
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

/// Volume of the unit sphere of dimension m over the volume of the unit ball of ℝᵐ: 2 and π for m = 0 and 1, and from
/// m to m + 2 it grows by the factor (m + 2)/(m + 1), as both volumes do by factors of 2π/(m + 1) and 2π/(m + 2).
Bounds sphere_over_ball(int m) {
  Rational rational(m % 2 == 0 ? 2 : 1);
  for (int lower = m % 2; lower < m; lower += 2) rational *= Rational(lower + 2) / Rational(lower + 1);
  return times_power_of_pi(rational, m % 2);
}

/// Volume of the unit sphere times the measured number of net points per volume ε^m.
std::optional<Bounds> measured_density(int m) {
  if (m == 2) return times_power_of_pi(Rational(4) * Rational(697) / Rational(1000), 1);
  if (m == 3) return times_power_of_pi(Rational(2) * Rational(743) / Rational(1000), 2);
  return std::nullopt;
}

}  // namespace

SphereSampleSize sphere_sample_size(Dimension dimension, const PowerProduct& sampling_radius) {
  const Bounds cells = power(sampling_radius, -dimension.value).bounds();
  const auto times_cells = [&](const Bounds& factor) {
    return Bounds{factor.lower * cells.lower, factor.upper * cells.upper};
  };
  SphereSampleSize result{times_cells(sphere_over_ball(dimension.value)), std::nullopt};
  if (const auto density = measured_density(dimension.value)) result.measured_estimate = times_cells(*density);
  return result;
}

}  // namespace delcert
