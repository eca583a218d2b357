#include "proofs/certificate/run_parameters.hpp"

#include "kernel/number/exact_text.hpp"
#include "kernel/run/chart_run.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// An upper bound of (5/2)(1 + δ₀μ₀/2) from Γ₀²: δ₀ = Γ₀^{m+1}.
Rational edge_bound(Dimension dimension, const Rational& separation, const Rational& squared_flake_parameter) {
  const Rational protection = square_root_upper(power(squared_flake_parameter, dimension.value + 1), 64);
  const Rational excess = protection * separation / Rational(2);
  // Rounded up, so that a number of thousands of digits does not enter every comparison.
  return Rational(Integer(5), Integer(2)) * (Rational(1) + rounded_up(excess, -128));
}

}  // namespace

std::string_view name_of(RunMode mode) {
  return mode == RunMode::theory ? "theory" : mode == RunMode::measured ? "measured" : "none";
}

std::string_view name_of(CandidateRule rule) {
  return rule == CandidateRule::pruned ? "pruned" : rule == CandidateRule::whole ? "whole" : "printed";
}

Rational default_tolerance(Dimension dimension) {
  constexpr std::array<long, 5> exponents{0, -5, -6, -12, -18};
  return Rational::power_of_two(exponents.at(static_cast<std::size_t>(dimension.value)));
}

ForbiddenPropertiesParameters<Rational> RunParameters::forbidden(const Rational& sampling_radius) const {
  const Rational squared_hoop_bound =
      Rational::power_of_two(26) * squared_flake_parameter / power(algorithm.separation, 6);
  return {squared_flake_parameter, squared_hoop_bound, (Rational(1) + algorithm.radius_variation) * sampling_radius,
          algorithm.edge_bound * sampling_radius};
}

RunParameters parameters_for(Dimension dimension, const Rational& separation, const ParameterChoice& choice,
                             const Rational& radius_variation) {
  const Rational most = largest_perturbation(separation, radius_variation, Rational(0));
  // A number of few digits.
  const Rational few_digits = radius_variation > Rational(0) ? rounded_down(most, binary_exponent(most) - 11) : most;
  const Rational perturbation = choice.perturbation.value_or(few_digits);
  if (perturbation <= Rational(0) || perturbation > most) {
    throw InputError("perturbation " + exact_text(perturbation) + " is not in (0, " +
                     (radius_variation > Rational(0) ? "μ₀/(4(1 + ε₀))" : "μ₀/4") +
                     "], μ₀ = " + exact_text(separation) +
                     (radius_variation > Rational(0) ? ", ε₀ = " + exact_text(radius_variation) : ""));
  }
  if (choice.constraints && choice.mode != RunMode::theory)
    throw InputError("the hypotheses can be chosen in theory mode only; mode is " + std::string(name_of(choice.mode)));
  const ParameterConstraints constraints = choice.constraints.value_or(ParameterConstraints::printed);
  const Ledger ledger = constants_for(dimension, separation, perturbation, radius_variation, Rational(0), constraints);
  const Rational factor = Rational(1) + radius_variation;
  RunParameters result;
  const bool chooses = dimension == Dimension(2) || dimension == Dimension(3);
  const PerturbationParameters usual = chooses ? measured_parameters(dimension, choice.seed) : PerturbationParameters();
  result.mode = choice.mode;
  result.constraints = constraints;
  result.algorithm.separation = separation;
  result.algorithm.perturbation = perturbation;
  result.algorithm.candidates = choice.candidates;
  result.algorithm.seed = choice.seed;
  result.algorithm.radius_variation = radius_variation;
  result.algorithm.circumradius_bound = Rational(2) * factor;
  result.algorithm.clearance = choice.clearance.value_or(usual.clearance);
  result.algorithm.choices = choice.choices.value_or(usual.choices);
  if (result.algorithm.clearance < Rational(0) || result.algorithm.clearance >= Rational(1)) {
    throw InputError("clearance " + exact_text(result.algorithm.clearance) + " is not in [0, 1)");
  }
  if (result.algorithm.choices == 0) throw InputError("choices: 0 is not at least 1");
  if (choice.mode == RunMode::measured) {
    result.algorithm.tolerance = choice.tolerance.value_or(default_tolerance(dimension));
    if (result.algorithm.tolerance <= Rational(0) || result.algorithm.tolerance >= perturbation) {
      throw InputError("tolerance " + exact_text(result.algorithm.tolerance) +
                       " is not in (0, ρ₀), ρ₀ = " + exact_text(perturbation));
    }
    // 2α̃₀ = 2¹⁷m^{3/2}Γ₀/μ₀³ is the tolerance.
    result.squared_flake_parameter = square(result.algorithm.tolerance) * power(separation, 6) *
                                     Rational::power_of_two(-34) / power(Rational(dimension.value), 3);
  } else {
    if (choice.tolerance)
      throw InputError("the tolerance is 2α̃₀ in theory mode; it can be chosen in measured mode only");
    result.algorithm.tolerance = ledger.tolerance.rational();
    result.squared_flake_parameter = ledger.flake_parameter.squared();
  }
  result.algorithm.edge_bound = edge_bound(dimension, separation, result.squared_flake_parameter) * factor;
  if (choice.mode == RunMode::none) result.algorithm.perturbation = Rational(0);
  return result;
}

}  // namespace delcert
