#include "proofs/certificate/space_form_claims.hpp"

#include <algorithm>

#include "kernel/delaunay/piecewise_flat.hpp"
#include "kernel/delaunay/riemannian_simplices.hpp"
#include "kernel/delaunay/stable_stars.hpp"
#include "kernel/topology/homology.hpp"

namespace delcert {

namespace {

template <int m>
void derive_level_2s(const SpaceFormAtlas<m>& atlas, const SpaceFormRun<m>& run, const Progress& progress,
                     SpaceFormClaims& claims, std::vector<std::string>& reasons) {
  const StarStability stability = check_stability<m>(atlas, run.points, geometry_of(atlas), run.complex, progress);
  if (!stability.failures.empty()) {
    reasons.push_back("level 2s: " + std::to_string(stability.differing) + " of " + std::to_string(stability.pairs) +
                      " stars differ in the chart of another label");
    return;
  }
  const Rational reach = Rational::exactly(std::max(run.margins.reach, stability.margins.reach));
  if (reach >= Rational(SpaceFormAtlas<m>::patch_factor) * atlas.sampling_radius() ||
      reach >= atlas.form().injectivity_radius.lower) {
    reasons.emplace_back("level 2s: charts would have to show more than their patches");
    return;
  }
  claims.reach = reach;
}

template <int m>
void derive_level_6(const SpaceFormAtlas<m>& atlas, const SpaceFormRun<m>& run, const Progress& progress,
                    SpaceFormClaims& claims, std::vector<std::string>& reasons) {
  const PiecewiseFlatReport flat =
      measure_piecewise_flat<m>(atlas, run.points, geometry_of(atlas), run.complex, run.model.circumradius, progress);
  if (!(flat.lower > 0)) {
    reasons.push_back("level 6: of " + std::to_string(flat.unrealised) + " simplices no flat one is certain");
    return;
  }
  claims.metric = SpaceFormClaims::Metric{{}, Rational::exactly(flat.lower), Rational::exactly(flat.upper)};
  if (m == 2 && flat.is_self_delaunay()) {
    // A little less, as the format asks for more than what is stated.
    claims.metric->weight = Rational::exactly(flat.least_weight) * (Rational(1) - Rational::power_of_two(-20));
  } else {
    reasons.push_back("level 6: " + std::to_string(flat.not_delaunay + flat.undecided) + " of " +
                      std::to_string(flat.hinges) + " hinges are not locally Delaunay, or not certainly");
  }
}

}  // namespace

template <int m>
SpaceFormClaims derive_space_form_claims(const SpaceFormAtlas<m>& atlas, const PerturbationParameters& parameters,
                                         const SpaceFormRun<m>& run, const Progress& progress,
                                         std::vector<std::string>& reasons) {
  const Rational moved = parameters.perturbation * atlas.sampling_radius();
  SpaceFormClaims claims;
  claims.stars = StarMargins{Rational::exactly(run.margins.protection), Rational::exactly(run.margins.thickness),
                             Rational::exactly(run.margins.circumradius)};
  const PureComplex complex = run.complex.label_complex();
  claims.manifold = ManifoldClaim{run.complex.simplices().size(), static_cast<long>(complex.euler_characteristic()),
                                  true, homology(complex)};
  claims.delaunay =
      SpaceFormClaims::Delaunay{Rational::exactly(run.model.protection), Rational::exactly(run.model.circumradius)};
  claims.triangulation = true;
  if (atlas.patch_radius() < Rational(SpaceFormAtlas<m>::patch_factor) * atlas.sampling_radius()) {
    reasons.emplace_back("level 0: patches are smaller than 9 sampling radii");
  } else {
    claims.density = claims.delaunay->circumradius + moved;
  }
  derive_level_2s(atlas, run, progress, claims, reasons);
  const RiemannianSimplices simplices =
      measure_riemannian_simplices<m>(atlas, run.points, geometry_of(atlas), run.complex, progress);
  if (simplices.holds == Verdict::proved && simplices.star_radius < simplices.scale) {
    claims.riemannian = SpaceFormClaims::RiemannianSimplices{Rational::exactly(simplices.thickness),
                                                             Rational::exactly(simplices.scale)};
  } else {
    reasons.emplace_back("level 5: stars are too large, or too thin, for Riemannian simplices");
  }
  derive_level_6(atlas, run, progress, claims, reasons);
  return claims;
}

template SpaceFormClaims derive_space_form_claims<2>(const SpaceFormAtlas<2>&, const PerturbationParameters&,
                                                     const SpaceFormRun<2>&, const Progress&,
                                                     std::vector<std::string>&);
template SpaceFormClaims derive_space_form_claims<3>(const SpaceFormAtlas<3>&, const PerturbationParameters&,
                                                     const SpaceFormRun<3>&, const Progress&,
                                                     std::vector<std::string>&);

RunParameters space_form_parameters(const PerturbationParameters& parameters, Dimension dimension, bool perturbed) {
  RunParameters result;
  result.mode = perturbed ? RunMode::measured : RunMode::none;
  result.algorithm = parameters;
  if (!perturbed) result.algorithm.perturbation = Rational(0);
  result.squared_flake_parameter = square(parameters.tolerance) * power(parameters.separation, 6) *
                                   Rational::power_of_two(-34) / power(Rational(dimension.value), 3);
  if (result.squared_flake_parameter == Rational(0)) result.squared_flake_parameter = Rational::power_of_two(-120);
  return result;
}

}  // namespace delcert
