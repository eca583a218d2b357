#pragma once

#include <optional>

#include "kernel/manifold/quotient/distortion.hpp"
#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/run_parameters.hpp"
#include "proofs/constants/riemannian_demand.hpp"

namespace delcert {

/// The stability lemma (lem:del.metric.stability) for all stars of a run, with what levels 1 and 4 of its certificate
/// state: a change of distances of Υμ₀′δ/36 in the ball U = B(p_i, radius) leaves star(i) as it is.
struct StabilityMargin {
  Rational radius;   ///< of U: the star and twice the covering radius of the perturbed points around it
  Rational centres;  ///< the labels of star(i) are no farther from p_i
  Rational allowed;  ///< Υμ₀′δ/36; Υ, δ and the covering radius as certified, μ₀′ by μ₀, ρ₀ and the charts
  /// Upper bounds of what transitions to the charts of these labels change distances in U by, and of the difference of
  /// distances in the chart and in M. Empty where none is known.
  std::optional<Rational> by_transitions;
  std::optional<Rational> by_charts;
};

/// What is known of a run on a space form besides its levels; none of them rests on it, but level 0 states ξ₀ and η.
struct SpaceFormDistortion {
  TransitionDistortion transitions;  ///< of patches, with centres no farther than two thirds of a patch
  double metric = 0;                 ///< η on balls of that radius, an upper bound
  Rational farthest;                 ///< the greatest distance p_i, p_j up to that radius that was found; a lower bound
  double needed = 0;                 ///< that pair has ξ_ij of at least this
  std::optional<StabilityMargin> stability;  ///< where levels 1 and 4 are claimed
  Ledger ledger;                             ///< for μ₀ and ρ₀ of the run (μ₀/4 if nothing is perturbed)
  RiemannianDemand demand;
  MeasuredNet net;
  Rational tolerance;                ///< of the run, in units of ε
  std::optional<StarMargins> stars;  ///< as level 1 claims them
};

/// Looks at some labels for the farthest pair. Needs rounding to nearest.
template <int m>
[[nodiscard]] SpaceFormDistortion measure_distortion(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters,
                                                     const Claims& claims);

}  // namespace delcert
