#include "proofs/certificate/space_form_claims.hpp"

#include "kernel/manifold/quotient/distortion.hpp"
#include "proofs/certificate/derivation.hpp"
#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {

namespace {

/// Levels 4 and 0. `whole_patches`: whether patches have a radius of 9ε.
void derive_delaunay(Derivation& derivation, const ModelReport& model, Curvature curvature,
                     const Rational& patch_radius, bool whole_patches) {
  Claims& claims = derivation.claims;
  if (!claims.manifold || (!derivation.selects("4") && !derivation.selects("0"))) return;
  const DelaunayClaim::Balls found{stated_below(model.protection), stated_above(model.circumradius)};
  if (!derivation.balls_fit("4", found.circumradius, found.protection)) return;
  claims.delaunay = DelaunayClaim{found, {}};
  if (!derivation.selects("0")) return;
  if (!whole_patches) {
    derivation.reasons.emplace_back("level 0: patches are smaller than 9 sampling radii");
    return;
  }
  InputClaim::Density density{stated_above(derivation.shift + found.circumradius), Rational(0), Rational(0)};
  if (curvature != Curvature::zero) {
    const Rational interest = patch_radius * Rational(2) / Rational(3);  // 6ε
    density.distortion = stated_above(transition_distortion(curvature, patch_radius, interest).of_pairs.upper);
    density.metric_distortion = stated_above(metric_distortion(curvature, interest));
  }
  claims.input = InputClaim{{}, density};
}

void derive_triangulation(Derivation& derivation, const RiemannianSimplices& simplices, Curvature curvature,
                          const Rational& injectivity_radius) {
  if (!derivation.selects("5") || !derivation.claims.delaunay) return;
  derivation.claims.triangulation = TriangulationClaim{"space-form", {}};
  if (!is_proved(simplices.holds)) return;
  const TriangulationClaim::RiemannianSimplices found{stated_below(simplices.thickness),
                                                      stated_above(simplices.star_radius)};
  const bool is_small = Rational(4) * found.radius <= injectivity_radius &&
                        (curvature == Curvature::zero || Rational(6) * found.radius <= found.thickness);
  if (is_small) derivation.claims.triangulation->riemannian = found;
}

void derive_metric(Derivation& derivation, const PiecewiseFlatReport& flat, bool is_surface) {
  if (!derivation.selects("6") || !derivation.claims.triangulation) return;
  if (!(flat.lower > 0)) {
    derivation.reasons.push_back("level 6: of " + std::to_string(flat.unrealised) +
                                 " simplices no flat one is certain");
    return;
  }
  MetricClaim metric{
      false, {}, stated_below(flat.lower, digits_of_stretches), stated_above(flat.upper, digits_of_stretches)};
  if (is_surface && flat.is_self_delaunay()) {
    metric.self_delaunay = true;
    metric.weight = stated_below(flat.least_weight);
  } else if (is_surface) {
    derivation.reasons.push_back("level 6: " + std::to_string(flat.not_delaunay + flat.undecided) + " of " +
                                 std::to_string(flat.hinges) + " hinges are not certainly locally Delaunay");
  }
  derivation.claims.metric = metric;
}

}  // namespace

template <int m>
SpaceFormMeasures measure_run(const SpaceFormAtlas<m>& atlas, const ChartRun<m>& run, const Progress& progress) {
  const ModelGeometry geometry = geometry_of<m>(atlas);
  return {check_stability<m>(atlas, run.points, geometry, run.complex, progress),
          measure_riemannian_simplices<m>(atlas, run.points, geometry, run.complex, progress),
          measure_piecewise_flat<m>(atlas, run.points, geometry, run.complex, run.model.circumradius, progress)};
}

template <int m>
Claims derive_claims(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters, const LocalMargins& margins,
                     const std::function<ManifoldClaim()>& manifold, const ModelReport& model,
                     const SpaceFormMeasures& measures, const LevelSelection& selection,
                     std::vector<std::string>& reasons) {
  const Curvature curvature = atlas.curvature();
  const Rational& injectivity_radius = atlas.form().injectivity_radius.lower;
  const Rational& patch = atlas.patch_radius();
  Derivation derivation{selection, reasons,
                        [&](const Rational& reach) { return reach < patch && reach < injectivity_radius; },
                        parameters.algorithm.perturbation * atlas.sampling_radius()};
  if (derivation.derive_margins(margins)) derivation.claims.manifold = manifold();
  derivation.derive_stability(measures.stability, margins.reach);
  if (curvature == Curvature::zero) derivation.widen_reach();
  derive_delaunay(derivation, model, curvature, patch,
                  Rational(SpaceFormAtlas<m>::patch_factor) * atlas.sampling_radius() <= patch);
  derive_triangulation(derivation, measures.simplices, curvature, injectivity_radius);
  derive_metric(derivation, measures.flat, m == 2);
  return std::move(derivation.claims);
}

template <int m>
Claims derive_claims(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters, const ChartRun<m>& run,
                     const SpaceFormMeasures& measures, const LevelSelection& selection,
                     std::vector<std::string>& reasons) {
  const auto manifold = [&run] {
    const PureComplex complex = run.complex.label_complex();
    return manifold_claim(complex, complex.count(m), true);
  };
  return derive_claims<m>(atlas, parameters, run.margins, manifold, run.model, measures, selection, reasons);
}

#define DELCERT_INSTANTIATE(m)                                                                                  \
  template Claims derive_claims<m>(const SpaceFormAtlas<m>&, const RunParameters&, const LocalMargins&,         \
                                   const std::function<ManifoldClaim()>&, const ModelReport&,                   \
                                   const SpaceFormMeasures&, const LevelSelection&, std::vector<std::string>&); \
  template SpaceFormMeasures measure_run<m>(const SpaceFormAtlas<m>&, const ChartRun<m>&, const Progress&);     \
  template Claims derive_claims<m>(const SpaceFormAtlas<m>&, const RunParameters&, const ChartRun<m>&,          \
                                   const SpaceFormMeasures&, const LevelSelection&, std::vector<std::string>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
