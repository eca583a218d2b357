#pragma once

#include <cstddef>

#include "proofs/constants/ledger.hpp"

namespace delcert {

/// A net on a space form of curvature −1, 0 or 1, as it was measured.
struct MeasuredNet {
  int curvature = 0;
  Rational injectivity_radius;  ///< of the manifold, a lower bound
  Rational sampling_radius;     ///< ε
  std::size_t points = 0;       ///< no two of them nearer to each other than separation·ε
};

/// What Theorem 3 (thm:riem.del.tri) asks of a net on the same manifold, with the same μ₀ and ρ₀.
struct RiemannianDemand {
  /// min{inj/4, 2⁻⁶(ρ₀/C̃)^{2m+1}}, as printed; inj/4 where there is no curvature.
  PowerProduct printed_radius;
  /// min{inj/20, 2⁻⁶(ρ₀/C̃)^{2m+1}}, which the proofs give (docs/claims/riemannian-constants.md).
  PowerProduct mended_radius;
  /// Every net of the printed radius has at least as many points: the balls of radius separation·ε/2 about the points
  /// of the measured net are disjoint, so that they bound the volume of the manifold from below; the balls of the
  /// demanded radius cover it.
  PowerProduct least_points;
  bool is_met = false;  ///< by the sampling radius of the measured net, with the mended radius
};

/// Precondition: the net has points, inj and ε are positive; dimension and separation of the ledger are its own, and
/// separation·ε < 1 on a sphere.
[[nodiscard]] RiemannianDemand riemannian_demand(const Ledger& ledger, const MeasuredNet& net);

}  // namespace delcert
