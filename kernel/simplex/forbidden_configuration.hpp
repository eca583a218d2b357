#pragma once

#include <cstddef>

#include "kernel/simplex/circumscribing_ball.hpp"
#include "kernel/simplex/flake.hpp"
#include "kernel/simplex/good.hpp"
#include "kernel/simplex/hoop.hpp"

namespace delcert {

/// The parameters of Definition 2, on squares.
template <Scalar S = Rational>
struct ForbiddenConfigurationParameters {
  S squared_flake_parameter;  ///< Γ₀², in (0, 1]
  S squared_sampling_radius;  ///< ε′² of the perturbed set
  S squared_protection;       ///< δ² = (δ₀μ₀′ε′)²

  /// The same parameters on another rung, for use with simplices of that rung.
  template <Scalar T>
  [[nodiscard]] ForbiddenConfigurationParameters<T> on() const {
    return {scalar_from<T>(squared_flake_parameter), scalar_from<T>(squared_sampling_radius),
            scalar_from<T>(squared_protection)};
  }
};

/// A forbidden configuration in ℝᵐ (Definition 2, def:forbidden.config): a (k+1)-simplex τ, k ≤ m, that is a Γ₀-flake
/// and has a vertex p such that τ_p has a circumscribing ball B(C, R) with R < ε′ and ||p − C| − R| ≤ δ.
/// Preconditions: the simplex is one of points of ℝᵐ.
template <Scalar S>
[[nodiscard]] Verdict is_forbidden_configuration(const EdgeGram<S>& simplex, std::size_t ambient_dimension,
                                                 const ForbiddenConfigurationParameters<S>& parameters) {
  if (simplex.dimension() == 0 || simplex.dimension() > ambient_dimension + 1) return Verdict::refuted;
  const Verdict flake = is_flake(simplex, parameters.squared_flake_parameter);
  if (is_refuted(flake)) return flake;
  // The facets of a flake are good, hence non-degenerate.
  const std::size_t normal_dimension = ambient_dimension - (simplex.dimension() - 1);
  Verdict some_ball = Verdict::refuted;
  for (std::size_t p = 0; p < simplex.vertex_count() && !is_proved(some_ball); ++p) {
    const auto offset = sphere_offset(simplex, p);
    some_ball = disjunction(
        some_ball, offset ? has_circumscribing_ball_near(*offset, normal_dimension, parameters.squared_sampling_radius,
                                                         parameters.squared_protection)
                          : offset.exists());
  }
  return conjunction(flake, some_ball);
}

/// The parameters of the properties P1 … P4 of forbidden configurations (lem:prop.forbid.cfg).
template <Scalar S = Rational>
struct ForbiddenPropertiesParameters {
  S squared_flake_parameter;  ///< Γ₀², in (0, 1]
  S squared_hoop_bound;       ///< α₀²
  S sampling_radius;          ///< ε of the original set, > 0
  S edge_bound;               ///< for (5/2)(1 + δ₀μ₀/2)ε, > 0; an upper bound of it errs towards `proved`

  /// The same parameters on another rung, for use with simplices of that rung.
  template <Scalar T>
  [[nodiscard]] ForbiddenPropertiesParameters<T> on() const {
    return {scalar_from<T>(squared_flake_parameter), scalar_from<T>(squared_hoop_bound),
            scalar_from<T>(sampling_radius), scalar_from<T>(edge_bound)};
  }
};

/// Whether the simplex has all the properties of lem:prop.forbid.cfg: P1 the α₀-hoop property; P2 R(τ_p) < 2ε for all
/// vertices p; P3 Δ(τ) < edge_bound; P4 every facet is Γ₀-good. Every forbidden configuration has them (under the
/// hypotheses of that lemma), but not only those: a simplex need not be a flake. Refuted for a vertex.
template <Scalar S>
[[nodiscard]] Verdict has_forbidden_properties(const EdgeGram<S>& simplex,
                                               const ForbiddenPropertiesParameters<S>& parameters) {
  if (simplex.dimension() == 0) return Verdict::refuted;
  Verdict result = less(squared_longest_edge(simplex), square(parameters.edge_bound));
  const S squared_radius_bound = S(4) * square(parameters.sampling_radius);
  for (std::size_t p = 0; p < simplex.vertex_count() && !is_refuted(result); ++p) {
    const auto offset = sphere_offset(simplex, p);
    if (!offset) {
      result = conjunction(result, offset.exists());
      continue;
    }
    result = conjunction(result, less(offset->squared_radius, squared_radius_bound));
    if (is_refuted(result)) break;
    result = conjunction(result, is_within_hoop(*offset, parameters.squared_hoop_bound));
  }
  if (is_refuted(result)) return result;
  return conjunction(result, are_facets_good(simplex, parameters.squared_flake_parameter));
}

}  // namespace delcert
