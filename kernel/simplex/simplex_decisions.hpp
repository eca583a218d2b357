#pragma once

#include <cstddef>

#include "kernel/simplex/exact_simplex.hpp"
#include "kernel/simplex/forbidden_configuration.hpp"

namespace delcert {

// The predicates of this folder on exactly given simplices, each on the lowest rung of the ladder that decides. With
// exact input none of them ends undecided. Parameters are squared where the predicates take squares.

/// Affinely independent vertices.
[[nodiscard]] Verdict decide_non_degenerate(const ExactSimplex& simplex);
/// D(p, σ)² ≥ squared_bound.
[[nodiscard]] Verdict decide_altitude_at_least(const ExactSimplex& simplex, std::size_t p,
                                               const Rational& squared_bound);
/// Υ(σ)² ≥ squared_bound > 0.
[[nodiscard]] Verdict decide_thickness_at_least(const ExactSimplex& simplex, const Rational& squared_bound);
/// There is a circumcentre and R(σ)² < squared_bound.
[[nodiscard]] Verdict decide_circumradius_below(const ExactSimplex& simplex, const Rational& squared_bound);
/// s_k(P) ≥ bound.
[[nodiscard]] Verdict decide_smallest_singular_value_at_least(const ExactSimplex& simplex,
                                                              const Rational& squared_bound);
/// s_1(P) ≤ bound.
[[nodiscard]] Verdict decide_largest_singular_value_at_most(const ExactSimplex& simplex, const Rational& squared_bound);
/// The facet opposite p has a circumcentre, and d(p, S(τ_p)) ≤ bound.
[[nodiscard]] Verdict decide_circumsphere_within(const ExactSimplex& simplex, std::size_t p,
                                                 const Rational& squared_bound);
/// The facet opposite p has a circumcentre, and d(p, S^{m−1}(τ_p)) ≤ bound.
[[nodiscard]] Verdict decide_diametric_sphere_within(const ExactSimplex& simplex, std::size_t p,
                                                     const Rational& squared_bound);
/// Γ₀-good.
[[nodiscard]] Verdict decide_good(const ExactSimplex& simplex, const Rational& squared_flake_parameter);
/// Γ₀-flake.
[[nodiscard]] Verdict decide_flake(const ExactSimplex& simplex, const Rational& squared_flake_parameter);
/// α₀-hoop property.
[[nodiscard]] Verdict decide_hoop_property(const ExactSimplex& simplex, const Rational& squared_hoop_bound);
/// Definition 2.
[[nodiscard]] Verdict decide_forbidden_configuration(const ExactSimplex& simplex, std::size_t ambient_dimension,
                                                     const ForbiddenConfigurationParameters<Rational>& parameters);
/// P1 … P4 of lem:prop.forbid.cfg.
[[nodiscard]] Verdict decide_forbidden_properties(const ExactSimplex& simplex,
                                                  const ForbiddenPropertiesParameters<Rational>& parameters);

}  // namespace delcert
