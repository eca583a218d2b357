#pragma once

#include <cstdint>

#include "kernel/number/rational.hpp"

namespace delcert {

/// Which simplices a perturbation is tested against.
enum class CandidateRule {
  /// Those of already perturbed points that could be the opposite facet in a forbidden configuration
  /// (docs/claims/pruned-candidates.md).
  pruned,
  /// All k-simplices, 1 ≤ k ≤ m, on the labels of the paper's 𝒮_i: for reference.
  whole,
  /// The m-simplices of the paper's 𝒮_i only, as Definition "Good perturbation" is printed: for comparison.
  printed,
};

/// What the perturbation algorithm is run with. Lengths are in units of the sampling radius ε_i.
struct PerturbationParameters {
  Rational separation;           ///< μ₀
  Rational perturbation;         ///< ρ₀: points move by at most ρ₀ε_i
  Rational radius_variation{0};  ///< ε₀: no radius in a patch is more than 1 + ε₀ times another
  Rational tolerance;            ///< a good perturbation is farther than this from every candidate sphere: 2α̃₀
  Rational edge_bound;  ///< candidates have shorter edges: (1+ξ₀)(1+ε₀)(5/2)(1+δ₀μ₀/2), or an upper bound
  Rational circumradius_bound;  ///< candidates have a smaller circumradius: 2(1+ε₀), that of lem:raw.hoop.distort
  CandidateRule candidates = CandidateRule::pruned;
  std::uint64_t seed = 0;
  std::uint32_t most_tries = 100000;  ///< for one point, before the run is given up

  /// A second tolerance, for the few candidates that can become Delaunay (`DelaunayCandidates`): of `choices` tries the
  /// good perturbation farthest from their spheres is taken; if that is no farther than this, tries go on, up to 16
  /// times as many. 0 and 1: the first good one.
  Rational clearance{0};
  std::uint32_t choices = 1;
};

}  // namespace delcert
