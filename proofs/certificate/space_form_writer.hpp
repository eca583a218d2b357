#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "kernel/manifold/quotient/space_form.hpp"
#include "kernel/simplex/vector.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/document.hpp"
#include "proofs/certificate/placed_complex.hpp"
#include "support/progress.hpp"

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
  Rational distortion;                            ///< with it: ξ₀ of the transitions between patches
  Rational metric_distortion;                     ///< with it: η of the charts against M
  std::optional<StarMargins> stars;               ///< level 1, in the charts
  std::optional<ManifoldClaim> manifold;          ///< level 2
  std::optional<Rational> reach;                  ///< level 2s: how far charts have to show
  std::optional<Delaunay> delaunay;               ///< level 4
  bool triangulation = false;                     ///< level 5
  std::optional<RiemannianSimplices> riemannian;  ///< level 5, by the second route as well
  std::optional<Metric> metric;                   ///< level 6
};

/// Everything that goes into a certificate of a space form. References are kept.
template <int m>
struct SpaceFormContent {
  const SpaceForm& form;
  const RunParameters& parameters;  ///< mode measured or none
  const Rational& sampling_radius;
  const std::vector<Vector<Rational, m>>& centres;  ///< conformal coordinates of the net
  const std::vector<Vector<Rational, m>>& vectors;  ///< tangent vectors of the perturbed points
  const PlacedComplex<m>& complex;
  const SpaceFormClaims& claims;
};

/// Writes a certificate as docs/certificate-format.md specifies, as `write_certificate` does.
template <int m>
void write_space_form_certificate(const std::filesystem::path& path, const SpaceFormContent<m>& content,
                                  const Progress& progress = no_progress());

/// The manifold block of a certificate: the group, exactly.
[[nodiscard]] std::string manifold_object(const SpaceForm& form);

/// "spherical", "flat", "hyperbolic".
[[nodiscard]] std::string_view family_of(Curvature curvature);

}  // namespace delcert
