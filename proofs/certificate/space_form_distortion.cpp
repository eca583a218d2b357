#include "proofs/certificate/space_form_distortion.hpp"

#include <algorithm>
#include <cmath>

namespace delcert {

namespace {

constexpr std::uint32_t labels_looked_at = 64;

/// A lower bound of the greatest distance of two centres among those that are at most `reach`.
template <int m>
Rational farthest_pair(const SpaceFormAtlas<m>& atlas, const Rational& reach) {
  double farthest = 0;
  const FilterGuard guard;
  const double bound = scalar_from<Filter>(reach).lower();
  std::vector<Sighting<m>> seen;
  for (std::uint32_t index = 0; index < std::min<std::size_t>(labels_looked_at, atlas.size()); ++index) {
    atlas.sightings(Label(index), bound, seen);
    for (const Sighting<m>& sighting : seen) {
      const Vector<Filter, m> v = atlas.carry(Label(index), sighting, Vector<Filter, m>{});
      const Filter distance = square_root(detail::sum_of_squares(v));
      if (distance.upper() <= bound) farthest = std::max(farthest, distance.lower());
    }
  }
  return Rational::exactly(farthest);
}

StabilityMargin stability_margin(Curvature curvature, const Rational& patch_radius, const Rational& epsilon,
                                 const PerturbationParameters& algorithm, const StarMargins& stars,
                                 const Rational& covering_radius) {
  // Charts may bring points nearer to each other than they are in M (K < 0), or farther (K > 0), by this factor.
  const Rational stretch = Rational::exactly(chart_stretch(curvature, patch_radius));
  const Rational& rho = algorithm.perturbation;
  Rational separation = (algorithm.separation - Rational(2) * rho) * epsilon;
  Rational sampling_radius = covering_radius;
  (curvature == Curvature::negative ? separation : sampling_radius) =
      curvature == Curvature::negative ? separation / stretch : sampling_radius * stretch;
  StabilityMargin result;
  const Rational star = rho * epsilon + Rational(2) * stars.circumradius;
  result.radius = star + Rational(2) * sampling_radius;
  result.centres = star + rho * epsilon;
  result.allowed = stars.thickness * (separation / sampling_radius) * stars.protection / Rational(36);
  // Points of U are in the patch, and their distance in M is the one that the chart shows, for it is below the
  // injectivity radius.
  if (result.radius > patch_radius * Rational(2) / Rational(3)) return result;
  const Rational diameter = Rational(2) * result.radius;
  const double by_transitions = ball_distortion(curvature, result.radius, result.centres);
  if (std::isfinite(by_transitions)) result.by_transitions = diameter * Rational::exactly(by_transitions);
  result.by_charts = diameter * Rational::exactly(metric_distortion(curvature, result.radius));
  return result;
}

}  // namespace

template <int m>
SpaceFormDistortion measure_distortion(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters,
                                       const Claims& claims) {
  const Curvature curvature = atlas.curvature();
  const Rational& patch = atlas.patch_radius();
  const Rational interest = patch * Rational(2) / Rational(3);
  const PerturbationParameters& algorithm = parameters.algorithm;
  SpaceFormDistortion result;
  result.transitions = transition_distortion(curvature, patch, interest);
  result.metric = metric_distortion(curvature, interest);
  if (curvature != Curvature::zero) {
    result.farthest = farthest_pair<m>(atlas, interest);
    result.needed = transition_distortion(curvature, patch, result.farthest).of_pairs.lower;
  }
  if (claims.stars && claims.delaunay) {
    result.stability = stability_margin(curvature, patch, atlas.sampling_radius(), algorithm, *claims.stars,
                                        claims.delaunay->balls->circumradius);
  }
  const Rational most = algorithm.separation / Rational(4);
  const Rational perturbation = algorithm.perturbation > Rational(0) ? minimum(algorithm.perturbation, most) : most;
  result.ledger = constants_for(Dimension(m), algorithm.separation, perturbation);
  result.net = {sign_of(curvature), atlas.form().injectivity_radius.lower, atlas.sampling_radius(), atlas.size()};
  result.demand = riemannian_demand(result.ledger, result.net);
  result.tolerance = algorithm.tolerance;
  result.stars = claims.stars;
  return result;
}

template SpaceFormDistortion measure_distortion<2>(const SpaceFormAtlas<2>&, const RunParameters&, const Claims&);
template SpaceFormDistortion measure_distortion<3>(const SpaceFormAtlas<3>&, const RunParameters&, const Claims&);

}  // namespace delcert
