#include "kernel/manifold/gluing/atlas_distortion.hpp"
#include "kernel/manifold/gluing/gluing_check.hpp"
#include "kernel/sample/separation.hpp"
#include "kernel/theorems/seam_homes.hpp"
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

  void derive(const LevelSelection& selection, const Progress& progress) override {
    AtlasMeasures<m> measures = measure_atlas<m>(*this->atlas_, *this->run_, geometry(), selection, progress);
    const bool is_to_refine =
        measures.triangulation && !measures.triangulation->failures.empty() && refinement_rounds_ > 0;
    const bool is_refined = is_to_refine && choose_homes(measures, selection, progress);
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

  std::shared_ptr<const ChartGluing> gluing_;
  int refinement_rounds_ = 0;
};

}  // namespace

std::unique_ptr<Family> family_of(const FormulaAtlasDescription& manifold) {
  if (manifold.dimension == Dimension(2)) return std::make_unique<AtlasFamily<2>>(manifold);
  return std::make_unique<AtlasFamily<3>>(manifold);
}

}  // namespace delcert
