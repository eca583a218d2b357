#include "proofs/certificate/claims.hpp"

#include <algorithm>

#include "kernel/manifold/lattice.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/perturb/forbidden_search.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "kernel/topology/homology.hpp"

namespace delcert {

namespace {

template <int m>
bool balls_lie_in_patches(const FlatAtlas<m>& atlas, const StarMargins& margins) {
  const Rational reach = Rational(2) * margins.circumradius + margins.protection;
  if (reach > Rational(8) * atlas.sampling_radius()) return false;
  return !atlas.space().is_torus() || square(Rational(2) * reach) < squared_systole<m>(atlas.metric());
}

}  // namespace

std::vector<std::string> Claims::names() const {
  std::vector<std::string> result;
  const auto add = [&result](bool claimed, const char* name) {
    if (claimed) result.emplace_back(name);
  };
  add(input.has_value(), "0");
  add(stars.has_value(), "1");
  add(manifold.has_value(), "2");
  add(stable_stars, "2s");
  add(no_forbidden.has_value(), "3");
  add(delaunay, "4");
  add(triangulation, "5");
  add(metric, "6");
  return result;
}

const LevelSelection& all_levels() {
  static const LevelSelection levels{"0", "1", "2", "2s", "3", "4", "5", "6"};
  return levels;
}

bool selects(const LevelSelection& selection, std::string_view level) {
  return std::find(selection.begin(), selection.end(), level) != selection.end();
}

template <int m>
Claims derive_claims(const FlatAtlas<m>& atlas, const RunParameters& parameters, const RunResult<m>& run,
                     const LevelSelection& selection, const Progress& progress, std::vector<std::string>& reasons) {
  Claims claims;
  const bool torus = atlas.space().is_torus();
  const StarMargins& margins = run.protection.margins.value();
  if (!balls_lie_in_patches<m>(atlas, margins)) {
    reasons.emplace_back("level 1: a circumball with its protection does not fit into a patch");
    return claims;
  }
  if (selects(selection, "0")) claims.input = parameters.mode == RunMode::theory;
  if (selects(selection, "1") || selects(selection, "2")) {
    claims.stars = margins;
    claims.manifold = ManifoldClaim{run.complex.simplices().size(), run.complex.euler_characteristic(), torus,
                                    homology(run.complex.label_complex())};
  }
  const Rational shift = Rational(2) * parameters.algorithm.perturbation * atlas.sampling_radius();
  if (selects(selection, "2s") && claims.manifold && claims.input) {
    claims.stable_stars = Rational(4) * margins.circumradius + shift < Rational(9) * atlas.sampling_radius();
    if (!claims.stable_stars) reasons.emplace_back("level 2s: a star does not fit into the patches of its vertices");
  }
  if (selects(selection, "3") && claims.input) {
    const auto search = search_forbidden<m>(atlas, run.points, parameters.forbidden(atlas.sampling_radius()),
                                            parameters.algorithm.perturbation * atlas.sampling_radius(), progress);
    if (search.found) {
      std::string labels;
      for (const Label label : *search.found) labels += " " + std::to_string(label.value);
      reasons.push_back("level 3: forbidden configuration (P1 to P4) of labels" + labels);
    } else {
      claims.no_forbidden = std::to_string(search.configurations) + " sets of 3 to " + std::to_string(m + 2) +
                            " points, " + std::to_string(search.decided_exactly) + " of them by exact P1 to P4";
    }
  }
  claims.delaunay = selects(selection, "4") && claims.manifold;
  claims.triangulation = selects(selection, "5") && claims.delaunay && torus;
  claims.metric = selects(selection, "6") && claims.triangulation;
  if (!torus && (selects(selection, "5") || selects(selection, "6"))) {
    reasons.emplace_back("levels 5 and 6: are for closed manifolds; the net of a ball has none to triangulate");
  }
  return claims;
}

#define DELCERT_INSTANTIATE(m)                                                                     \
  template Claims derive_claims<m>(const FlatAtlas<m>&, const RunParameters&, const RunResult<m>&, \
                                   const LevelSelection&, const Progress&, std::vector<std::string>&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
