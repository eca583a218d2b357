#pragma once

#include <vector>

#include "kernel/chart/sampling_radii.hpp"
#include "kernel/stars/proposal.hpp"
#include "support/progress.hpp"

namespace delcert {

/// How dense a net of a flat torus is, certified, where that varies (docs/levels/0-input.md, Radii that vary).
template <int m>
struct GradedDensity {
  /// ε_i, in the proportions that were asked for: the least, nearly, that the rest allows.
  SamplingRadii radii{Rational(0)};
  /// ε₀: lifts closer than 9(1 + ε₀) times the greater of their radii have radii that differ by no more than ε₀ times
  /// the lesser.
  Rational radius_variation;
  /// The witness: oriented simplices that cover, each with its vertices in an open ball whose radius, times 1 + ε₀, is
  /// the least of their radii.
  std::vector<LiftedSimplex<m>> simplices;
};

/// Measures a net for radii in these proportions. Throws Rejection when the density cannot be certified, or no such ε₀
/// is at most 1: radii vary too much from a point to those near it. Precondition: the space is a torus.
template <int m>
[[nodiscard]] GradedDensity<m> measure_graded_density(const FlatSpace<m>& space, const PointSet<m>& net,
                                                      const SamplingRadii& proportions, const Progress& progress);

}  // namespace delcert
