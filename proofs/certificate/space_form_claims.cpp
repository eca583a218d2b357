#include "proofs/certificate/space_form_claims.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernel/delaunay/piecewise_flat.hpp"
#include "kernel/delaunay/riemannian_simplices.hpp"
#include "kernel/delaunay/stable_stars.hpp"
#include "kernel/number/elementary.hpp"
#include "kernel/topology/homology.hpp"

namespace delcert {

namespace {

constexpr long margin_digits = 12;

/// A number of 12 binary digits that is less than x > 0, and one that is more.
Rational below(double x) {
  const Rational less = Rational::exactly(x) * (Rational(1) - Rational::power_of_two(-40));
  return rounded_down(less, binary_exponent(less) - margin_digits + 1);
}
Rational above(double x) {
  const Rational more = Rational::exactly(x) * (Rational(1) + Rational::power_of_two(-40));
  return rounded_up(more, binary_exponent(more) - margin_digits + 1);
}

template <int m>
class Derivation {
 public:
  Derivation(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters, const SpaceFormRun<m>& run,
             const LevelSelection& selection, const Progress& progress, std::vector<std::string>& reasons)
      : atlas_(atlas),
        parameters_(parameters),
        run_(run),
        selection_(selection),
        progress_(progress),
        reasons_(reasons),
        geometry_(geometry_of(atlas)),
        epsilon_(atlas.sampling_radius()) {}

  SpaceFormClaims derive() {
    if (!run_.is_certified()) throw std::invalid_argument("the run is not certified");
    if (!stars()) return result_;
    if (is_selected("2s")) stable_stars();
    if (!is_selected("4") || !delaunay()) return result_;
    if (is_selected("0")) density();
    if (!is_selected("5")) return result_;
    triangulation();
    if (is_selected("6")) metric();
    return result_;
  }

 private:
  [[nodiscard]] bool is_selected(const std::string& level) const {
    return std::find(selection_.begin(), selection_.end(), level) != selection_.end();
  }
  bool refuse(const std::string& level, const std::string& why) {
    reasons_.push_back("level " + level + ": " + why);
    return false;
  }
  /// Whether the reach is less than the injectivity radius and, on a sphere, a right angle.
  [[nodiscard]] bool is_short(const Rational& reach) const {
    if (reach >= geometry_.injectivity_radius) return false;
    if (geometry_.curvature != Curvature::positive) return true;
    return is_proved(less(BigInterval(Rational(2) * reach), half_turn()));
  }
  [[nodiscard]] Rational displacement() const { return parameters_.algorithm.perturbation * epsilon_; }

  bool stars() {
    if (!is_selected("1") || !is_selected("2")) return false;
    const StarMargins margins{below(run_.margins.protection), below(run_.margins.thickness),
                              above(run_.margins.circumradius)};
    const Rational reach = displacement() + Rational(2) * margins.circumradius + margins.protection;
    if (reach >= Rational(9) * epsilon_ || !is_short(reach))
      return refuse("1", "stars reach farther than patches, or than the injectivity radius");
    result_.stars = margins;
    progress_("homology", 0, 1);
    const PureComplex complex = run_.complex.label_complex();
    ManifoldClaim manifold;
    manifold.simplices = complex.count(m);
    manifold.euler_characteristic = complex.euler_characteristic();
    manifold.homology = homology(complex);
    result_.manifold = manifold;
    progress_("homology", 1, 1);
    return true;
  }

  void stable_stars() {
    const StarStability stability = check_stability<m>(atlas_, run_.points, geometry_, run_.complex, progress_);
    if (!stability.failures.empty()) {
      refuse("2s", std::to_string(stability.stars) + " stars differ in the charts of their vertices; label " +
                       std::to_string(stability.failures.front().label.value) + ": " +
                       stability.failures.front().reason);
      return;
    }
    const Rational reach = above(std::max(run_.margins.reach, stability.margins.reach));
    if (reach >= Rational(9) * epsilon_ || !is_short(reach)) {
      refuse("2s", "stars reach farther than patches in the charts of their vertices");
      return;
    }
    result_.reach = reach;
  }

  bool delaunay() {
    const SpaceFormClaims::Delaunay claim{below(run_.model.protection), above(run_.model.circumradius)};
    if (!is_short(displacement() + Rational(2) * claim.circumradius + claim.protection))
      return refuse("4", "circumballs reach farther than the injectivity radius");
    result_.delaunay = claim;
    return true;
  }

  void density() {
    if (!is_separated<m>(atlas_, parameters_.algorithm.separation * epsilon_)) {
      refuse("0", "points of the net are nearer to each other than the separation says");
      return;
    }
    result_.density = result_.delaunay->circumradius + displacement();
  }

  void triangulation() {
    result_.triangulation = true;
    const auto measured = measure_riemannian_simplices<m>(atlas_, run_.points, geometry_, run_.complex, progress_);
    if (!(measured.thickness > 0)) return;
    const SpaceFormClaims::RiemannianSimplices claim{below(measured.thickness), above(measured.star_radius)};
    const bool is_flat = geometry_.curvature == Curvature::zero;
    if (Rational(4) * claim.radius > geometry_.injectivity_radius ||
        (!is_flat && Rational(6) * claim.radius > claim.thickness)) {
      refuse("5", "by Riemannian simplices too: stars are too large for their thickness");
      return;
    }
    result_.riemannian = claim;
  }

  void metric() {
    const auto measured =
        measure_piecewise_flat<m>(atlas_, run_.points, geometry_, run_.complex, run_.model.circumradius, progress_);
    if (!(measured.lower > 0)) {
      refuse("6", std::to_string(measured.unrealised) + " simplices have no flat one with their edge lengths");
      return;
    }
    SpaceFormClaims::Metric claim{std::nullopt, Rational(1), Rational(1)};
    if (geometry_.curvature != Curvature::zero) {
      claim.least_stretch = below(measured.lower);
      claim.greatest_stretch = above(measured.upper);
    }
    if (m == 2) {
      if (measured.is_self_delaunay()) {
        claim.weight = below(measured.least_weight);
      } else {
        refuse("6", "not self-Delaunay");
      }
    }
    result_.metric = claim;
  }

  const SpaceFormAtlas<m>& atlas_;
  const RunParameters& parameters_;
  const SpaceFormRun<m>& run_;
  const LevelSelection& selection_;
  const Progress& progress_;
  std::vector<std::string>& reasons_;
  ModelGeometry geometry_;
  Rational epsilon_;
  SpaceFormClaims result_;
};

}  // namespace

template <int m>
SpaceFormClaims derive_space_form_claims(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters,
                                         const SpaceFormRun<m>& run, const LevelSelection& selection,
                                         const Progress& progress, std::vector<std::string>& reasons) {
  return Derivation<m>(atlas, parameters, run, selection, progress, reasons).derive();
}

template <int m>
void write_space_form_run(const std::filesystem::path& path, const SpaceFormAtlas<m>& atlas,
                          const RunParameters& parameters, const SpaceFormRun<m>& run, const SpaceFormClaims& claims,
                          const Progress& progress) {
  std::vector<Vector<Rational, m>> centres;
  std::vector<Vector<Rational, m>> vectors;
  std::vector<std::vector<std::array<std::uint32_t, static_cast<std::size_t>(m)>>> stars;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    centres.push_back(atlas.centre(Label(index)));
    vectors.push_back(run.points.exact(Label(index)));
    stars.push_back(run.complex.star(Label(index)));
  }
  write_space_form_certificate<m>(
      path, {atlas.form(), parameters, atlas.sampling_radius(), centres, vectors, stars, claims}, progress);
}

template <int m>
bool is_separated(const SpaceFormAtlas<m>& atlas, const Rational& distance) {
  const FilterGuard guard;
  const auto metric = atlas.metric().template on<Filter>();
  const Filter squared = scalar_from<Filter>(square(distance));
  const double reach = approximate_double(distance) * (1 + 0x1p-20);
  std::vector<Sighting<m>> seen;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    atlas.sightings(Label(index), reach, seen);
    for (const Sighting<m>& other : seen) {
      if (other.index == index && other.shift == Shift<m>{}) continue;
      // Distances from the centre of a chart are those in the manifold.
      const auto position = atlas.carry(Label(index), other, Vector<Filter, m>{});
      if (!is_proved(less_equal(squared, metric.squared_norm(position)))) return false;
    }
  }
  return true;
}

RunParameters space_form_parameters(Dimension dimension, std::uint64_t seed) {
  const PerturbationParameters algorithm = measured_parameters(dimension, seed);
  ParameterChoice choice;
  choice.mode = RunMode::measured;
  choice.perturbation = algorithm.perturbation;
  choice.tolerance = algorithm.tolerance;
  choice.seed = seed;
  RunParameters result = parameters_for(dimension, algorithm.separation, choice);
  result.algorithm = algorithm;
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                         \
  template SpaceFormClaims derive_space_form_claims<m>(const SpaceFormAtlas<m>&, const RunParameters&,                 \
                                                       const SpaceFormRun<m>&, const LevelSelection&, const Progress&, \
                                                       std::vector<std::string>&);                                     \
  template void write_space_form_run<m>(const std::filesystem::path&, const SpaceFormAtlas<m>&, const RunParameters&,  \
                                        const SpaceFormRun<m>&, const SpaceFormClaims&, const Progress&);              \
  template bool is_separated<m>(const SpaceFormAtlas<m>&, const Rational&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
