#include "proofs/certificate/metric_field_claims.hpp"

#include <algorithm>

#include "kernel/topology/homology.hpp"

namespace delcert {

namespace {

constexpr long slack_exponent = -20;
constexpr long digits = 12;

/// The number with 12 binary digits next below x(1 − 2⁻²⁰), next above x(1 + 2⁻²⁰). Precondition: x > 0.
Rational below(double x) {
  const Rational weaker = Rational::exactly(x) * (Rational(1) - Rational::power_of_two(slack_exponent));
  return rounded_down(weaker, binary_exponent(weaker) - digits + 1);
}
Rational above(double x) {
  const Rational weaker = Rational::exactly(x) * (Rational(1) + Rational::power_of_two(slack_exponent));
  return rounded_up(weaker, binary_exponent(weaker) - digits + 1);
}

}  // namespace

std::vector<std::string> MetricFieldClaims::names() const {
  std::vector<std::string> result;
  const auto add = [&result](bool claimed, const char* name) {
    if (claimed) result.emplace_back(name);
  };
  add(stars.has_value(), "1");
  add(manifold.has_value(), "2");
  add(reach.has_value(), "2s");
  add(triangulation, "5");
  return result;
}

template <int m>
MetricFieldClaims derive_claims(const MetricFieldAtlas<m>& atlas, const RunParameters& parameters,
                                const SpaceFormRun<m>& run, const MetricFieldMeasures& measures,
                                const LevelSelection& selection, std::vector<std::string>& reasons) {
  const auto selects = [&selection](const char* level) {
    return std::find(selection.begin(), selection.end(), level) != selection.end();
  };
  MetricFieldClaims claims;
  const Rational patch = atlas.patch_radius();
  const Rational shift = parameters.algorithm.perturbation * atlas.sampling_radius();
  const StarMargins margins{below(run.margins.protection), below(run.margins.thickness),
                            above(run.margins.circumradius)};
  if (!(Rational(2) * shift + Rational(2) * margins.circumradius + margins.protection < patch)) {
    reasons.emplace_back("level 1: a circumball with its protection does not fit into a patch");
    return claims;
  }
  if (selects("1") || selects("2")) {
    claims.stars = margins;
    const PureComplex complex = run.complex.label_complex();
    claims.manifold = ManifoldClaim{run.complex.simplices().size(), static_cast<long>(complex.euler_characteristic()),
                                    true, homology(complex)};
  }
  if (selects("2s") && claims.manifold) {
    const StarStability& stability = measures.stability;
    const Rational reach = above(std::max(run.margins.reach, stability.margins.reach));
    if (stability.differing > 0) {
      reasons.push_back("level 2s: " + std::to_string(stability.stars) + " stars are not the same in all charts (" +
                        std::to_string(stability.differing) + " of " + std::to_string(stability.pairs) + " pairs)");
    } else if (reach < patch) {
      claims.reach = reach;
    } else {
      reasons.emplace_back("level 2s: a star does not fit into the patches of its vertices");
    }
  }
  if (selects("4")) reasons.emplace_back("level 4: not claimed on metric fields");
  if (selects("5") && claims.manifold) {
    claims.triangulation = measures.triangulation.holds();
    if (!claims.triangulation)
      reasons.push_back("level 5: " + std::to_string(measures.triangulation.other_lifts) +
                        " simplices are seen at other lifts elsewhere, and at most " +
                        std::to_string(measures.triangulation.most_sheets) + " sheets cover the torus");
  }
  return claims;
}

#define DELCERT_INSTANTIATE(m)                                                                    \
  template MetricFieldClaims derive_claims<m>(const MetricFieldAtlas<m>&, const RunParameters&,   \
                                              const SpaceFormRun<m>&, const MetricFieldMeasures&, \
                                              const LevelSelection&, std::vector<std::string>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
