#include "proofs/certificate/space_form_claims.hpp"

#include "kernel/manifold/quotient/distortion.hpp"
#include "kernel/topology/homology.hpp"
#include "proofs/certificate/stability_claim.hpp"
#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {

namespace {

template <int m>
class Derivation {
 public:
  Derivation(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters, const ChartRun<m>& run,
             const SpaceFormMeasures& measures, const LevelSelection& selection, std::vector<std::string>& reasons)
      : run_(run),
        measures_(measures),
        selection_(selection),
        reasons_(reasons),
        curvature_(atlas.curvature()),
        injectivity_radius_(atlas.form().injectivity_radius.lower),
        patch_radius_(atlas.patch_radius()),
        has_whole_patches_(Rational(SpaceFormAtlas<m>::patch_factor) * atlas.sampling_radius() <= patch_radius_),
        shift_(parameters.algorithm.perturbation * atlas.sampling_radius()) {}

  SpaceFormClaims claims() {
    derive_stars();
    derive_stability();
    derive_delaunay();
    derive_triangulation();
    derive_metric();
    return std::move(claims_);
  }

 private:
  [[nodiscard]] bool selects(const char* level) const { return delcert::selects(selection_, level); }
  [[nodiscard]] bool fits(const Rational& reach) const { return reach < patch_radius_ && reach < injectivity_radius_; }

  void derive_stars() {
    if (!selects("1") && !selects("2")) return;
    const StarMargins margins{stated_below(run_.margins.protection), stated_below(run_.margins.thickness),
                              stated_above(run_.margins.circumradius)};
    if (!fits(shift_ + Rational(2) * margins.circumradius + margins.protection)) {
      reasons_.emplace_back("level 1: a circumball with its protection does not fit into a patch");
      return;
    }
    claims_.stars = margins;
    const PureComplex complex = run_.complex.label_complex();
    claims_.manifold = ManifoldClaim{run_.complex.simplices().size(), static_cast<long>(complex.euler_characteristic()),
                                     true, homology(complex)};
  }

  void derive_stability() {
    if (!selects("2s") || !claims_.manifold) return;
    claims_.reach = derive_reach(
        measures_.stability, run_.margins.reach, [&](const Rational& reach) { return fits(reach); }, reasons_);
  }

  void derive_delaunay() {
    if (!claims_.manifold || (!selects("4") && !selects("0"))) return;
    const SpaceFormClaims::Delaunay found{stated_below(run_.model.protection), stated_above(run_.model.circumradius)};
    if (!fits(shift_ + Rational(2) * found.circumradius + found.protection)) {
      reasons_.emplace_back("level 4: a circumball with its protection does not fit into a patch");
      return;
    }
    claims_.delaunay = found;
    if (!selects("0")) return;
    if (has_whole_patches_) {
      claims_.density = stated_above(shift_ + found.circumradius);
      derive_distortion();
    } else {
      reasons_.emplace_back("level 0: patches are smaller than 9 sampling radii");
    }
  }

  void derive_distortion() {
    if (curvature_ == Curvature::zero) return;
    const Rational interest = patch_radius_ * Rational(2) / Rational(3);  // 6ε
    claims_.distortion = stated_above(transition_distortion(curvature_, patch_radius_, interest).of_pairs.upper);
    claims_.metric_distortion = stated_above(metric_distortion(curvature_, interest));
  }

  void derive_triangulation() {
    if (!selects("5") || !claims_.delaunay) return;
    claims_.triangulation = true;
    if (!is_proved(measures_.simplices.holds)) return;
    const SpaceFormClaims::RiemannianSimplices found{stated_below(measures_.simplices.thickness),
                                                     stated_above(measures_.simplices.star_radius)};
    const bool is_small = Rational(4) * found.radius <= injectivity_radius_ &&
                          (curvature_ == Curvature::zero || Rational(6) * found.radius <= found.thickness);
    if (is_small) claims_.riemannian = found;
  }

  void derive_metric() {
    if (!selects("6") || !claims_.triangulation) return;
    const PiecewiseFlatReport& flat = measures_.flat;
    if (!(flat.lower > 0)) {
      reasons_.push_back("level 6: of " + std::to_string(flat.unrealised) + " simplices no flat one is certain");
      return;
    }
    SpaceFormClaims::Metric metric{
        {}, stated_below(flat.lower, digits_of_stretches), stated_above(flat.upper, digits_of_stretches)};
    if (m == 2) {
      if (flat.is_self_delaunay()) {
        metric.weight = stated_below(flat.least_weight);
      } else {
        reasons_.push_back("level 6: " + std::to_string(flat.not_delaunay + flat.undecided) + " of " +
                           std::to_string(flat.hinges) + " hinges are not certainly locally Delaunay");
      }
    }
    claims_.metric = metric;
  }

  const ChartRun<m>& run_;
  const SpaceFormMeasures& measures_;
  const LevelSelection& selection_;
  std::vector<std::string>& reasons_;
  Curvature curvature_;
  Rational injectivity_radius_;
  Rational patch_radius_;
  bool has_whole_patches_;
  Rational shift_;  // ρ₀ε
  SpaceFormClaims claims_;
};

}  // namespace

template <int m>
SpaceFormMeasures measure_run(const SpaceFormAtlas<m>& atlas, const ChartRun<m>& run, const Progress& progress) {
  const ModelGeometry geometry = geometry_of<m>(atlas);
  return {check_stability<m>(atlas, run.points, geometry, run.complex, progress),
          measure_riemannian_simplices<m>(atlas, run.points, geometry, run.complex, progress),
          measure_piecewise_flat<m>(atlas, run.points, geometry, run.complex, run.model.circumradius, progress)};
}

template <int m>
SpaceFormClaims derive_claims(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters, const ChartRun<m>& run,
                              const SpaceFormMeasures& measures, const LevelSelection& selection,
                              std::vector<std::string>& reasons) {
  return Derivation<m>(atlas, parameters, run, measures, selection, reasons).claims();
}

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

std::vector<std::string> names_of(const SpaceFormClaims& claims) {
  std::vector<std::string> result;
  const auto add = [&result](bool claimed, const char* name) {
    if (claimed) result.emplace_back(name);
  };
  add(claims.density.has_value(), "0");
  add(claims.stars.has_value(), "1");
  add(claims.manifold.has_value(), "2");
  add(claims.reach.has_value(), "2s");
  add(claims.delaunay.has_value(), "4");
  add(claims.triangulation, "5");
  add(claims.metric.has_value(), "6");
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                  \
  template SpaceFormMeasures measure_run<m>(const SpaceFormAtlas<m>&, const ChartRun<m>&, const Progress&);     \
  template SpaceFormClaims derive_claims<m>(const SpaceFormAtlas<m>&, const RunParameters&, const ChartRun<m>&, \
                                            const SpaceFormMeasures&, const LevelSelection&,                    \
                                            std::vector<std::string>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
