#include "kernel/manifold/gluing/atlas_distortion.hpp"
#include "kernel/manifold/gluing/gluing_check.hpp"
#include "kernel/sample/separation.hpp"
#include "kernel/theorems/seam_homes.hpp"
#include "kernel/theorems/stable_patches.hpp"
#include "proofs/certificate/atlas_claims.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certification/chart_family.hpp"

namespace delcert {

namespace {

/// Charts by formulas, glued to a manifold.
template <int m>
class AtlasFamily final : public ChartFamily<m, FormulaAtlas<m>> {
 public:
  using Family::report;

  explicit AtlasFamily(const FormulaAtlasDescription& manifold)
      : ChartFamily<m, FormulaAtlas<m>>(false), gluing_(std::make_shared<const ChartGluing>(manifold)) {
    report.manifold = manifold.name;
    report.family = "atlas";
    report.dimension = Dimension(m);
    report.gluing = RunReport::Gluing{manifold.charts.size(), manifold.transitions.size(), check_gluing(*gluing_), {}};
  }

  void make_net(const NetSource& source, const Progress& progress) override {
    auto places = source.places<m>(*gluing_, progress);  // first: refuses a source without a radius
    this->take_atlas(FormulaAtlas<m>(gluing_, std::move(places), *source.radius));
    report.parameters.algorithm.separation = measure_separation<m>(*this->atlas_);
  }

  [[nodiscard]] NetText net() const override {
    PointList points = this->centres();
    for (std::uint32_t index = 0; index < points.size(); ++index)
      points[index].insert(points[index].begin(), Rational(Integer(this->atlas_->home_chart(Label(index)))));
    return {std::move(points), "the number of a chart and coordinates in it"};
  }

  void choose_parameters(const CertifyOptions& options, const Progress& progress) override {
    refuse_theory_mode(options, "an atlas");
    report.gluing->distortion = fit_patches<m>(*this->atlas_, progress);
    report.patch_factor = this->atlas_->patch_factor();
    this->choose_measured_parameters(options);
    refinement_rounds_ = options.refinement_rounds;
  }

  void run(RunRequest request, const Progress& progress) override {
    ChartFamily<m, FormulaAtlas<m>>::run(request, progress);
    const auto& stability = this->run_->stability;
    if (stability && stability->stars > stability->occupied) (void)reach_stability(*stability, true, progress);
  }

  void derive(const LevelSelection& selection, const Progress& progress) override {
    AtlasMeasures<m> measures = measure_atlas<m>(*this->atlas_, *this->run_, geometry(), selection, progress);
    const bool is_to_refine =
        measures.triangulation && !measures.triangulation->failures.empty() && refinement_rounds_ > 0;
    const bool is_refined = is_to_refine && choose_homes(measures, selection, progress);
    if (is_refined && selects(selection, "2s") && reach_stability(measures.stability, false, progress))
      measures.stability = *this->run_->stability;
    report.claims =
        derive_claims<m>(*this->atlas_, report.parameters, *this->run_, measures, selection, report.reasons);
    if (is_to_refine && !is_refined) {
      report.reasons.push_back("refinement: in " + std::to_string(refinement_rounds_) +
                               " rounds no home charts were found with which levels 1, 2 and 5 hold");
    }
    report.stability = measures.stability;
    this->require_homology(gluing_->description().homology);
  }

  void write(const std::string& path, const Progress& progress) const override {
    write_certificate<m>(
        path, content_of<m>(*this->atlas_, report.gluing->distortion, report.parameters, *this->run_, report.claims),
        progress);
  }

 private:
  /// Wider patches, and other points if they may be placed anew, where these make level 2s hold. False, and nothing has
  /// changed, if they do not.
  bool reach_stability(const StarStability& found, bool places_anew, const Progress& progress) {
    const ChartRun<m> before = *this->run_;
    const int factor = this->atlas_->patch_factor();
    const Rational distortion = report.gluing->distortion;
    if (!widen(found, progress)) return false;
    if (!this->run_->stability->failures.empty() && places_anew) {
      this->run_.emplace(
          run_in_charts<m>(*this->atlas_, geometry(), report.parameters.algorithm, this->request_, progress));
    }
    const ChartRun<m>& now = *this->run_;
    if (now.is_certified() && now.stability && now.stability->failures.empty()) {
      report.take(now);
      return true;
    }
    this->run_.emplace(before);
    this->atlas_->set_patch_factor(factor);
    report.gluing->distortion = distortion;
    report.patch_factor = factor;
    return false;
  }

  /// Wider patches, in which no star lacks room. False if there are none.
  bool widen(const StarStability& stability, const Progress& progress) {
    auto found = widen_patches<m>(*this->atlas_, this->run_->points, this->run_->complex, stability, progress);
    if (!found) return false;
    this->run_->stability = std::move(found->stability);
    report.gluing->distortion = found->distortion;
    report.patch_factor = this->atlas_->patch_factor();
    return true;
  }

  /// Other home charts, where that makes level 5 hold and is certified on levels 1 and 2. False if there are none.
  [[nodiscard]] bool choose_homes(AtlasMeasures<m>& measures, const LevelSelection& selection,
                                  const Progress& progress) {
    auto homes = homes_without_folds<m>(gluing_, *this->atlas_, this->run_->points, this->run_->complex.simplices(),
                                        refinement_rounds_, progress);
    if (!homes) return false;
    FormulaAtlas<m> atlas(gluing_, homes->net, this->atlas_->sampling_radius());
    const Rational distortion = fit_patches<m>(atlas, progress);
    const ModelGeometry seen = geometry_of<m>(atlas, distortion);
    ChartRun<m> run = stars_in_charts<m>(atlas, seen, std::move(homes->points), this->request_, progress);
    if (!run.is_certified()) return false;
    AtlasMeasures<m> found = measure_atlas<m>(atlas, run, seen, selection, progress);
    if (!found.triangulation->triangulates()) return false;
    run.statistics = this->run_->statistics;
    run.repair_rounds = this->run_->repair_rounds;
    run.repaired_points = this->run_->repaired_points;
    measures = std::move(found);
    this->atlas_.emplace(std::move(atlas));
    this->run_.emplace(std::move(run));
    report.gluing->distortion = distortion;
    report.patch_factor = this->atlas_->patch_factor();
    report.refinement_rounds = homes->rounds;
    report.parameters.algorithm.separation = measure_separation<m>(*this->atlas_);
    report.take(*this->run_);
    return true;
  }

  [[nodiscard]] ModelGeometry geometry() const override {
    return geometry_of<m>(*this->atlas_, report.gluing->distortion);
  }

  [[nodiscard]] bool repairs_stability() const override { return true; }

  std::shared_ptr<const ChartGluing> gluing_;
  int refinement_rounds_ = 0;
};

}  // namespace

std::unique_ptr<Family> family_of(const FormulaAtlasDescription& manifold) {
  if (manifold.dimension == Dimension(2)) return std::make_unique<AtlasFamily<2>>(manifold);
  return std::make_unique<AtlasFamily<3>>(manifold);
}

}  // namespace delcert
