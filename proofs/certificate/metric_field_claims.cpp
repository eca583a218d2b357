#include "proofs/certificate/metric_field_claims.hpp"

#include "kernel/number/decimal_bounds.hpp"
#include "kernel/topology/homology.hpp"
#include "proofs/certificate/stability_claim.hpp"
#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {

std::vector<std::string> MetricFieldClaims::names() const {
  std::vector<std::string> result;
  const auto add = [&result](bool claimed, const char* name) {
    if (claimed) result.emplace_back(name);
  };
  add(stars.has_value(), "1");
  add(manifold.has_value(), "2");
  add(reach.has_value(), "2s");
  add(delaunay.has_value(), "4");
  add(triangulation, "5");
  return result;
}

namespace {

/// Level 4, or why it is not reached.
void claim_delaunay(MetricFieldClaims& claims, Dimension dimension, const ChartDistortion& distortion,
                    const AffineTriangulationReport& triangulation, const Rational& sampling_radius,
                    std::vector<std::string>& reasons) {
  if (!triangulation.holds()) {
    reasons.emplace_back("level 4: straight simplices do not triangulate the torus");
    return;
  }
  const DelaunayMargin margin =
      delaunay_margin(dimension, distortion.metric, *claims.stars, stated_below(triangulation.edge));
  claims.stability = margin;
  if (Rational(0) < margin.value()) {
    claims.delaunay = {margin.edge, stated_below(margin.value())};
  } else {
    reasons.push_back("level 4: the metric varies too much in a patch: margin of stability ≥ " +
                      decimal_lower(margin.value() / square(sampling_radius), 4) + " ε²");
  }
}

}  // namespace

template <int m>
MetricFieldClaims derive_claims(const MetricFieldAtlas<m>& atlas, const RunParameters& parameters,
                                const ChartDistortion& distortion, const ChartRun<m>& run,
                                const MetricFieldMeasures& measures, const LevelSelection& selection,
                                std::vector<std::string>& reasons) {
  MetricFieldClaims claims;
  const Rational patch = atlas.patch_radius();
  const Rational shift = parameters.algorithm.perturbation * atlas.sampling_radius();
  const StarMargins margins{stated_below(run.margins.protection), stated_below(run.margins.thickness),
                            stated_above(run.margins.circumradius)};
  if (!(Rational(2) * shift + Rational(2) * margins.circumradius + margins.protection < patch)) {
    reasons.emplace_back("level 1: a circumball with its protection does not fit into a patch");
    return claims;
  }
  if (selects(selection, "1") || selects(selection, "2")) {
    claims.stars = margins;
    const PureComplex complex = run.complex.label_complex();
    claims.manifold = ManifoldClaim{run.complex.simplices().size(), static_cast<long>(complex.euler_characteristic()),
                                    true, homology(complex)};
  }
  if (selects(selection, "2s") && claims.manifold) {
    claims.reach = derive_reach(
        measures.stability, run.margins.reach, [&](const Rational& reach) { return reach < patch; }, reasons);
  }
  if (selects(selection, "4") && claims.manifold)
    claim_delaunay(claims, Dimension(m), distortion, measures.triangulation, atlas.sampling_radius(), reasons);
  if (selects(selection, "5") && claims.manifold) {
    claims.triangulation = measures.triangulation.holds();
    if (!claims.triangulation)
      reasons.push_back("level 5: " + std::to_string(measures.triangulation.other_lifts) +
                        " simplices are seen at other lifts elsewhere, and at most " +
                        std::to_string(measures.triangulation.most_sheets) + " sheets cover the torus");
  }
  return claims;
}

#define DELCERT_INSTANTIATE(m)                                                                                        \
  template MetricFieldClaims derive_claims<m>(const MetricFieldAtlas<m>&, const RunParameters&,                       \
                                              const ChartDistortion&, const ChartRun<m>&, const MetricFieldMeasures&, \
                                              const LevelSelection&, std::vector<std::string>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
