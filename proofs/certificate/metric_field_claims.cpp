#include "proofs/certificate/metric_field_claims.hpp"

#include "kernel/number/decimal_bounds.hpp"
#include "proofs/certificate/derivation.hpp"
#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {

namespace {

/// Level 4, or why it is not reached.
void claim_delaunay(Derivation& derivation, Dimension dimension, const ChartDistortion& distortion,
                    const AffineTriangulationReport& triangulation, const Rational& sampling_radius) {
  Claims& claims = derivation.claims;
  if (!triangulation.holds()) {
    derivation.reasons.emplace_back("level 4: straight simplices do not triangulate the torus");
    return;
  }
  const DelaunayMargin margin =
      delaunay_margin(dimension, distortion.metric, *claims.stars, stated_below(triangulation.edge));
  claims.delaunay_margin = margin;
  if (Rational(0) < margin.value()) {
    claims.delaunay = DelaunayClaim{{}, DelaunayClaim::Stability{margin.edge, stated_below(margin.value())}};
  } else {
    derivation.reasons.push_back("level 4: the metric varies too much in a patch: margin of stability ≥ " +
                                 decimal_lower(margin.value() / square(sampling_radius), 4) + " ε²");
  }
}

}  // namespace

template <int m>
Claims derive_claims(const MetricFieldAtlas<m>& atlas, const RunParameters& parameters,
                     const ChartDistortion& distortion, const ChartRun<m>& run, const MetricFieldMeasures& measures,
                     const LevelSelection& selection, std::vector<std::string>& reasons) {
  const Rational shift = Rational(2) * parameters.algorithm.perturbation * atlas.sampling_radius();
  Derivation derivation = derivation_in_patches<m>(atlas, run, measures.stability, shift, selection, reasons);
  Claims& claims = derivation.claims;
  if (selects(selection, "4") && claims.manifold)
    claim_delaunay(derivation, Dimension(m), distortion, measures.triangulation, atlas.sampling_radius());
  if (selects(selection, "5") && claims.manifold) {
    if (measures.triangulation.holds()) {
      claims.triangulation = TriangulationClaim{"affine-charts", {}};
    } else {
      reasons.push_back("level 5: " + std::to_string(measures.triangulation.other_lifts) +
                        " simplices are seen at other lifts elsewhere, and at most " +
                        std::to_string(measures.triangulation.most_sheets) + " sheets cover the torus");
    }
  }
  return claims;
}

#define DELCERT_INSTANTIATE(m)                                                                               \
  template Claims derive_claims<m>(const MetricFieldAtlas<m>&, const RunParameters&, const ChartDistortion&, \
                                   const ChartRun<m>&, const MetricFieldMeasures&, const LevelSelection&,    \
                                   std::vector<std::string>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
