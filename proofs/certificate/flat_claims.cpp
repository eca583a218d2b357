#include "proofs/certificate/flat_claims.hpp"

#include <future>

#include "kernel/manifold/lattice.hpp"
#include "kernel/parallel/threads.hpp"
#include "kernel/perturb/forbidden_search.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

template <int m>
bool balls_lie_in_patches(const FlatAtlas<m>& atlas, const StarMargins& margins) {
  const Rational reach = Rational(2) * margins.circumradius + margins.protection;
  if (reach > Rational(8) * atlas.sampling_radius()) return false;
  return !atlas.space().is_torus() || square(Rational(2) * reach) < squared_systole<m>(atlas.metric());
}

}  // namespace

template <int m>
Claims derive_claims(const FlatAtlas<m>& atlas, const RunParameters& parameters, const RunResult<m>& run,
                     const LevelSelection& selection, const Progress& progress, std::vector<std::string>& reasons) {
  Claims claims;
  const bool torus = atlas.space().is_torus();
  const StarMargins& margins = run.protection.margins.value();
  const Rational shift = parameters.algorithm.perturbation * atlas.sampling_radius();
  if (!balls_lie_in_patches<m>(atlas, margins)) {
    reasons.emplace_back("level 1: a circumball with its protection does not fit into a patch");
    return claims;
  }
  std::future<ManifoldClaim> manifold;  // found in one thread while level 3 is searched in parts
  if (selects(selection, "0"))
    claims.input = InputClaim{parameters.mode == RunMode::theory, {}, parameters.constraints};
  if (selects(selection, "1") || selects(selection, "2")) {
    claims.stars = margins;
    manifold = std::async(thread_limit() > 1 ? std::launch::async : std::launch::deferred, [&] {
      return manifold_claim(run.complex.label_complex(), run.complex.simplices().size(), torus);
    });
    if (thread_limit() == 1) manifold.wait();
  }
  if (selects(selection, "2s") && manifold.valid() && claims.input) {
    if (Rational(4) * margins.circumradius + Rational(2) * shift < Rational(9) * atlas.sampling_radius()) {
      claims.stable_stars.emplace();
    } else {
      reasons.emplace_back("level 2s: a star does not fit into the patches of its vertices");
    }
  }
  if (selects(selection, "3") && claims.input) {
    const auto search =
        search_forbidden<m>(atlas, run.points, parameters.forbidden(atlas.sampling_radius()), shift, progress);
    if (search.found) {
      std::string labels;
      for (const Label label : *search.found) labels += " " + std::to_string(label.value);
      reasons.push_back("level 3: forbidden configuration (P1 to P4) of labels" + labels);
    } else {
      claims.no_forbidden = std::to_string(search.configurations) + " sets of 3 to " + std::to_string(m + 2) +
                            " points, " + std::to_string(search.decided_exactly) + " of them by exact P1 to P4";
    }
  }
  if (manifold.valid()) claims.manifold = manifold.get();
  if (selects(selection, "4") && claims.manifold) claims.delaunay.emplace();
  if (selects(selection, "5") && claims.delaunay && torus) claims.triangulation = TriangulationClaim{"space-form", {}};
  if (selects(selection, "6") && claims.triangulation) claims.metric = MetricClaim{true, {}};
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
