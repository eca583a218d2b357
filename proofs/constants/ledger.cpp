#include "proofs/constants/ledger.hpp"

#include <fmt/format.h>

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

[[noreturn]] void refuse(std::string_view parameter, const std::string& value, std::string_view range) {
  throw InputError(fmt::format("{} is {}; allowed: {}", parameter, value, range));
}

void require_domain(const Ledger& ledger) {
  const Rational zero(0);
  const Rational one(1);
  if (ledger.dimension.value < 1 || ledger.dimension > largest_ledger_dimension)
    refuse("dimension", std::to_string(ledger.dimension.value), fmt::format("1 to {}", largest_ledger_dimension.value));
  if (ledger.separation > one)
    refuse("separation", exact_text(ledger.separation),
           "above 0 and at most 1 (a net of larger separation is also a net of separation 1: use min(1, measured))");
  if (ledger.separation <= zero) refuse("separation", exact_text(ledger.separation), "above 0 and at most 1");
  if (ledger.distortion < zero || ledger.distortion >= one)
    refuse("distortion", exact_text(ledger.distortion), "at least 0 and below 1");
  if (ledger.radius_variation < zero || ledger.radius_variation > ledger.radius_variation_bound)
    refuse("radius variation", exact_text(ledger.radius_variation),
           fmt::format("0 to (1 - distortion)/(1 + distortion) = {}", exact_text(ledger.radius_variation_bound)));
  if (ledger.perturbation <= zero || ledger.perturbation_tilde > ledger.perturbation_tilde_bound)
    refuse(
        "perturbation", exact_text(ledger.perturbation),
        fmt::format("above 0 and at most {} (separation/4, divided by (1 + radius variation)(1 + distortion))",
                    exact_text(largest_perturbation(ledger.separation, ledger.radius_variation, ledger.distortion))));
}

/// δ₀ rounded up: to a power of 2 near 2^-128 where it is smaller, else to 128 digits.
Rational upper_bound_of(const PowerProduct& protection_parameter) {
  Rational tiny = Rational::power_of_two(-128);
  if (protection_parameter.log2().upper <= Rational(-128)) return tiny;
  return square_root_upper(protection_parameter.squared(), 192);
}

}  // namespace

std::string_view name_of(ParameterConstraints constraints) {
  return constraints == ParameterConstraints::sharper ? "sharper" : "printed";
}

Ledger constants_for(Dimension dimension, const Rational& separation, const Rational& perturbation,
                     const Rational& radius_variation, const Rational& distortion, ParameterConstraints constraints) {
  const Rational one(1);
  const bool is_sharper = constraints == ParameterConstraints::sharper;
  Ledger ledger;
  ledger.constraints = constraints;
  ledger.dimension = dimension;
  ledger.separation = separation;
  ledger.perturbation = perturbation;
  ledger.radius_variation = radius_variation;
  ledger.distortion = distortion;
  if (distortion >= Rational(0)) ledger.radius_variation_bound = (one - distortion) / (one + distortion);
  ledger.perturbation_tilde_bound = separation / Rational(4);
  ledger.flake_parameter_bound = Rational(2) * separation * separation / Rational(75);
  ledger.perturbation_tilde = (one + radius_variation) * (one + distortion) * perturbation;
  require_domain(ledger);

  const Rational& tilde = ledger.perturbation_tilde;
  ledger.perturbed_separation = (separation - Rational(2) * tilde) / (one + tilde);
  ledger.perturbed_radius_ratio = one + tilde;

  const long m = dimension.value;
  const PowerProduct mu(separation);
  const PowerProduct two(Rational(2));
  const PowerProduct root_of_m_cubed = PowerProduct::square_root_of(power(Rational(m), 3));
  const auto divisor = [&](long leading) { return root_of_m_cubed * power(two / mu, leading * m * m + 5 * m + 21); };

  ledger.flake_divisor = is_sharper ? divisor(4) / root_of_m_cubed : divisor(4);
  ledger.flake_parameter = PowerProduct(perturbation) / ledger.flake_divisor;
  const PowerProduct& flake = ledger.flake_parameter;
  ledger.protection_parameter = power(flake, m + 1);
  ledger.protection = ledger.protection_parameter * PowerProduct(separation - Rational(2) * tilde);
  ledger.hoop_bound = power(two, 13) * flake / power(mu, 3);
  const PowerProduct hoop_factor = is_sharper ? PowerProduct(Rational(17410)) : power(two, 16) * root_of_m_cubed;
  ledger.hoop_bound_tilde = hoop_factor * flake / power(mu, 3);
  ledger.tolerance = two * ledger.hoop_bound_tilde;
  ledger.longest_edge_excess = PowerProduct(Rational(5) / Rational(4)) * ledger.protection_parameter * mu;
  ledger.longest_edge_upper =
      Rational(5) / Rational(2) * (one + upper_bound_of(ledger.protection_parameter) * separation / Rational(2));
  ledger.candidates_bound = power(PowerProduct(Rational(14)) / mu, m * m + m);

  // That of hoops is the one that decides.
  const long hoop_exponent = is_sharper ? m + 1 : 2 * m + 1;
  ledger.distortion_bound = power(flake, 2 * hoop_exponent) / power(two, 4);
  ledger.stable_stars_distortion_bound = power(flake, 2 * m + 1) * power(mu, 2) / power(two, 12);
  ledger.hoop_distortion_bound = power(power(flake, hoop_exponent) / PowerProduct(Rational(4)), 2);
  ledger.metric_distortion_bound = power(mu, 2) / power(two, 12) * power(flake, 2 * m + 1);

  // Exponent and power of 2 in the bounds of sampling radii on manifolds.
  const long radius_exponent = is_sharper ? m + 1 : 2 * m + 1;
  const PowerProduct radius_divisor = power(two, is_sharper ? 5 : 6);
  ledger.chart_sampling_radius = power(flake, radius_exponent) / radius_divisor;
  ledger.riemannian_perturbation = minimum(perturbation, separation / Rational(5));
  ledger.riemannian_flake_divisor = is_sharper ? ledger.flake_divisor : divisor(5);
  ledger.riemannian_flake_parameter = PowerProduct(ledger.riemannian_perturbation) / ledger.riemannian_flake_divisor;
  ledger.riemannian_sampling_radius = power(ledger.riemannian_flake_parameter, radius_exponent) / radius_divisor;
  ledger.self_delaunay_sampling_radius = power(ledger.riemannian_flake_parameter, 2 * m + 1) / radius_divisor;
  ledger.piecewise_flat_distortion = PowerProduct(Rational(is_sharper ? 320 : 256)) *
                                     power(ledger.riemannian_flake_parameter, -2 * m) *
                                     power(ledger.riemannian_sampling_radius, 2);
  return ledger;
}

Rational largest_perturbation(const Rational& separation, const Rational& radius_variation,
                              const Rational& distortion) {
  const Rational zero(0);
  const Rational one(1);
  if (radius_variation < zero || distortion < zero) return separation / Rational(4);
  return separation / (Rational(4) * (one + radius_variation) * (one + distortion));
}

bool satisfies_parameter_constraints(const Ledger& ledger) {
  return ledger.distortion == Rational(0) || PowerProduct(ledger.distortion) <= ledger.distortion_bound;
}

}  // namespace delcert
