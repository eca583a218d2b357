#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/delaunay/piecewise_flat.hpp"
#include "kernel/delaunay/riemannian_simplices.hpp"
#include "kernel/delaunay/stable_stars.hpp"
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

/// What is measured of a certified run on a space form beyond levels 1, 2 and 4.
struct SpaceFormMeasures {
  StarStability stability;        ///< level 2s
  RiemannianSimplices simplices;  ///< level 5, by the theorem of Dyer, Vegter and Wintraecken
  PiecewiseFlatReport flat;       ///< level 6
};

/// Precondition: the run is certified. Needs rounding to nearest.
template <int m>
[[nodiscard]] SpaceFormMeasures measure_run(const SpaceFormAtlas<m>& atlas, const SpaceFormRun<m>& run,
                                            const Progress& progress);

/// Derives the levels from a certified run and its measures, checking the inequalities of docs/certificate-format.md
/// on the way; reasons for levels that are not reached are appended to `reasons`. Bounds that the format asks to be
/// strict are weaker than what was found by a relative 2⁻²⁰ at least: a reader with other enclosures finds them too.
template <int m>
[[nodiscard]] SpaceFormClaims derive_claims(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters,
                                            const SpaceFormRun<m>& run, const SpaceFormMeasures& measures,
                                            const LevelSelection& selection, std::vector<std::string>& reasons);

/// The parameters as certificates state them, of a run that perturbed or did not. Γ₀ is that for which the tolerance is
/// 2α̃₀, as on flat manifolds; nothing is claimed of it.
[[nodiscard]] RunParameters space_form_parameters(const PerturbationParameters& parameters, Dimension dimension,
                                                  bool perturbed);

/// The names of the levels claimed, in order.
[[nodiscard]] std::vector<std::string> names_of(const SpaceFormClaims& claims);

}  // namespace delcert
