#include "proofs/certificate/submanifold_claims.hpp"

#include <fmt/format.h>

#include "kernel/number/decimal_bounds.hpp"
#include "proofs/certificate/derivation.hpp"
#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {

namespace {

constexpr int digits_of_reasons = 4;

template <int m>
std::string reason_of(const GraphTriangulation<m>& triangulation) {
  if (triangulation.failures.empty()) {
    return fmt::format("level 5: in {} components no label is certainly alone over its place, that of label {} first",
                       triangulation.unclear.size(), triangulation.unclear.front().value);
  }
  const GraphSimplexFailure<m>& first = triangulation.failures.front();
  return fmt::format("level 5: {} simplices are not certainly mapped to the manifold as they should be; simplex {}: {}",
                     triangulation.failures.size(), fmt::join(first.simplex, " "), description_of(first.cause));
}

}  // namespace

template <int m>
void claim_graph(const GraphTriangulation<m>& triangulation, const Rational& unit, const LevelSelection& selection,
                 Claims& claims, std::vector<std::string>& reasons) {
  if (!claims.manifold || !(selects(selection, "5") || selects(selection, "5i"))) return;
  if (!triangulation.triangulates()) {
    reasons.push_back(reason_of(triangulation));
    return;
  }
  claims.triangulation =
      TriangulationClaim{"graph", {}, TriangulationClaim::Graph{triangulation.contraction, triangulation.displacement}};
  if (!selects(selection, "5i")) return;
  if (triangulation.is_isotopic()) {
    claims.isotopy = IsotopyClaim{stated_below(triangulation.margin)};
  } else if (triangulation.above_lid > 0) {
    reasons.push_back(fmt::format("level 5i: {} simplices are too near to the lids of cylinders of their labels",
                                  triangulation.above_lid));
  } else {
    reasons.push_back(
        fmt::format("level 5i: stars are not wide enough for what points are moved: margin ≥ {} ε, at label {}",
                    decimal_lower(Rational::exactly(triangulation.margin) / unit, digits_of_reasons),
                    triangulation.tightest.value));
  }
}

template <int m>
Claims derive_claims(const SubmanifoldAtlas<m>& atlas, const RunParameters& parameters, const ChartRun<m>& run,
                     const SubmanifoldMeasures<m>& measures, const LevelSelection& selection,
                     std::vector<std::string>& reasons) {
  Derivation derivation{selection, reasons,
                        [patch = atlas.patch_radius()](const Rational& reach) { return reach < patch; },
                        parameters.algorithm.perturbation * atlas.sampling_radius()};
  derivation.derive_stars(run);
  derivation.derive_stability(measures.stability, run.margins.reach);
  claim_graph<m>(measures.triangulation, atlas.sampling_radius(), selection, derivation.claims, reasons);
  return derivation.claims;
}

#define DELCERT_INSTANTIATE(m)                                                                                       \
  template Claims derive_claims<m>(const SubmanifoldAtlas<m>&, const RunParameters&, const ChartRun<m>&,             \
                                   const SubmanifoldMeasures<m>&, const LevelSelection&, std::vector<std::string>&); \
  template void claim_graph<m>(const GraphTriangulation<m>&, const Rational&, const LevelSelection&, Claims&,        \
                               std::vector<std::string>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
