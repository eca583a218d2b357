#include "proofs/certificate/atlas_claims.hpp"

#include <fmt/format.h>

#include "proofs/certificate/derivation.hpp"

namespace delcert {

namespace {

template <int m>
std::string reason_of(const FormulaAtlas<m>& atlas, const BlendedTriangulation<m>& triangulation) {
  if (!triangulation.failures.empty()) {
    const BlendFailure<m>& first = triangulation.failures.front();
    return fmt::format(
        "level 5: {} of {} simplices between charts are not certainly mapped as they should be; simplex {}: {}",
        triangulation.failures.size(), triangulation.seams, fmt::join(first.simplex, " "), description_of(first.cause));
  }
  if (!triangulation.unclear.empty()) {
    return fmt::format(
        "level 5: in {} components every label is near to simplices between charts, that of label {} first",
        triangulation.unclear.size(), triangulation.unclear.front().value);
  }
  return "level 5: chart " + atlas.gluing().chart(triangulation.unseen.front()).name + " shows no label";
}

}  // namespace

template <int m>
AtlasMeasures<m> measure_atlas(const FormulaAtlas<m>& atlas, const ChartRun<m>& run, const ModelGeometry& geometry,
                               const LevelSelection& selection, const Progress& progress) {
  AtlasMeasures<m> result{
      run.stability ? *run.stability : check_stability<m>(atlas, run.points, geometry, run.complex, progress), {}};
  if (selects(selection, "5"))
    result.triangulation = check_blended_triangulation<m>(atlas, run.points, run.complex.simplices());
  return result;
}

template <int m>
Claims derive_claims(const FormulaAtlas<m>& atlas, const RunParameters& parameters, const ChartRun<m>& run,
                     const AtlasMeasures<m>& measures, const LevelSelection& selection,
                     std::vector<std::string>& reasons) {
  const Rational shift = parameters.algorithm.perturbation * atlas.sampling_radius();
  Derivation derivation = derivation_in_patches<m>(atlas, run, measures.stability, shift, selection, reasons);
  if (!selects(selection, "5") || !derivation.claims.manifold || !measures.triangulation) return derivation.claims;
  const BlendedTriangulation<m>& triangulation = *measures.triangulation;
  if (triangulation.triangulates()) {
    derivation.claims.triangulation = TriangulationClaim{
        "blended-charts", {}, TriangulationClaim::Graph{triangulation.contraction, triangulation.displacement}};
  } else {
    reasons.push_back(reason_of(atlas, triangulation));
  }
  return derivation.claims;
}

#define DELCERT_INSTANTIATE(m)                                                                                 \
  template AtlasMeasures<m> measure_atlas<m>(const FormulaAtlas<m>&, const ChartRun<m>&, const ModelGeometry&, \
                                             const LevelSelection&, const Progress&);                          \
  template Claims derive_claims<m>(const FormulaAtlas<m>&, const RunParameters&, const ChartRun<m>&,           \
                                   const AtlasMeasures<m>&, const LevelSelection&, std::vector<std::string>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
