#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/number/strong.hpp"
#include "kernel/perturb/parameters.hpp"
#include "kernel/simplex/forbidden_configuration.hpp"
#include "proofs/constants/ledger.hpp"

namespace delcert {

/// How the tolerances of a run are chosen.
enum class RunMode {
  theory,    ///< every constant as in the paper's Hypotheses 2 and Lemma "Algorithm guarantee"
  measured,  ///< tolerances are parameters; what holds is what is certified afterwards
  none,      ///< no perturbation
};

/// "theory", "measured", "none"; "pruned", "whole", "printed": as in files.
[[nodiscard]] std::string_view name_of(RunMode mode);
[[nodiscard]] std::string_view name_of(CandidateRule rule);

/// What a certificate says of its origin besides versions, name → text: the command, the commit. Nothing verifies it.
using Origin = std::vector<std::pair<std::string, std::string>>;

/// The parameters of a run and the paper's constants that go with them, for ξ₀ = 0.
struct RunParameters {
  RunMode mode = RunMode::theory;
  ParameterConstraints constraints = ParameterConstraints::printed;  ///< theory mode: which Hypotheses 2
  PerturbationParameters algorithm;
  /// Γ₀². In measured mode that Γ₀ for which the tolerance is 2α̃₀.
  Rational squared_flake_parameter;
  Origin origin{};

  /// For the search of level 3, lengths: α₀ = 2¹³Γ₀/μ₀³, 1 + ε₀ times the greatest sampling radius, the edge bound.
  [[nodiscard]] ForbiddenPropertiesParameters<Rational> forbidden(const Rational& sampling_radius) const;
};

/// What a user may set; everything else follows.
struct ParameterChoice {
  RunMode mode = RunMode::theory;
  std::optional<ParameterConstraints> constraints;  ///< theory mode only; by default the printed ones
  std::optional<Rational> perturbation;  ///< ρ₀; by default μ₀/(4(1 + ε₀)), if ε₀ is not 0 in 12 binary digits
  std::optional<Rational> tolerance;     ///< measured mode only; by default one per dimension
  /// The second tolerance and the number of tries of `PerturbationParameters`; by default those of
  /// `measured_parameters` in dimensions 2 and 3, and the first good perturbation in the others.
  std::optional<Rational> clearance;
  std::optional<std::uint32_t> choices;
  CandidateRule candidates = CandidateRule::pruned;
  std::uint64_t seed = 0;
};

/// The tolerance of measured mode in this dimension: a few per cent of what the first tries of random perturbations
/// still satisfy (docs/cli.md has the figures).
[[nodiscard]] Rational default_tolerance(Dimension dimension);

/// Throws InputError for a value out of range, for a tolerance in theory mode, and for constraints in another mode.
/// `radius_variation`: ε₀, at most 1.
[[nodiscard]] RunParameters parameters_for(Dimension dimension, const Rational& separation,
                                           const ParameterChoice& choice,
                                           const Rational& radius_variation = Rational(0));

}  // namespace delcert
