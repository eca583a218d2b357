#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/perturb/space_form_run.hpp"
#include "proofs/certificate/claims.hpp"

namespace delcert {

/// The levels that a run on a space form reaches, with their margins: lengths, not in units of ε.
struct SpaceFormClaims {
  struct Delaunay {
    Rational protection;  ///< every other lift is farther than this from each circumball; 0 if only emptiness is known
    Rational circumradius;  ///< no circumball in M is larger
  };
  struct RiemannianSimplices {
    Rational thickness;  ///< of the simplices in the charts at perturbed points
    Rational radius;     ///< all vertices of a star are nearer than this to its label
  };
  struct Metric {
    std::optional<Rational> weight;  ///< of surfaces: cotangents opposite to an edge sum to more than this ≥ 0
    Rational least_stretch, greatest_stretch;
  };

  std::optional<Rational> density;                ///< level 0: every point of M is nearer than this to the net
  std::optional<StarMargins> stars;               ///< level 1, in the charts
  std::optional<ManifoldClaim> manifold;          ///< level 2
  std::optional<Rational> reach;                  ///< level 2s: how far charts have to show
  std::optional<Delaunay> delaunay;               ///< level 4
  bool triangulation = false;                     ///< level 5
  std::optional<RiemannianSimplices> riemannian;  ///< level 5, by the second route as well
  std::optional<Metric> metric;                   ///< level 6
};

/// Derives the levels from a certified run, measuring what levels 2s, 5 and 6 state; reasons for levels, or parts of
/// them, that are not reached are appended to `reasons`. The separation of the net is not looked at: level 0 states it
/// as the parameters do. Precondition: the run is certified.
template <int m>
[[nodiscard]] SpaceFormClaims derive_space_form_claims(const SpaceFormAtlas<m>& atlas,
                                                       const PerturbationParameters& parameters,
                                                       const SpaceFormRun<m>& run, const Progress& progress,
                                                       std::vector<std::string>& reasons);

/// The parameters as certificates state them, of a run that perturbed or did not. Γ₀ is that for which the tolerance is
/// 2α̃₀, as on flat manifolds; nothing is claimed of it.
[[nodiscard]] RunParameters space_form_parameters(const PerturbationParameters& parameters, Dimension dimension,
                                                  bool perturbed);

}  // namespace delcert
