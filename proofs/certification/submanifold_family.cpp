#include <set>

#include "kernel/manifold/submanifold_file.hpp"
#include "kernel/sample/radius_advice.hpp"
#include "kernel/sample/separation.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/submanifold_claims.hpp"
#include "proofs/certification/chart_family.hpp"

namespace delcert {

namespace {

/// Zero sets of equations, in tangent charts.
template <int m>
class SubmanifoldFamily final : public ChartFamily<m, SubmanifoldAtlas<m>> {
 public:
  using Family::report;

  explicit SubmanifoldFamily(const SubmanifoldDescription& manifold)
      : ChartFamily<m, SubmanifoldAtlas<m>>(false), manifold_(embedded_manifold(manifold)) {
    report.manifold = manifold.name;
    report.family = "submanifold";
    report.dimension = Dimension(m);
    report.graphs.emplace();
    report.graphs->ambient_dimension = manifold_->ambient();
  }

  void make_net(const NetSource& source, const Progress& progress) override {
    this->run_.reset();
    failed_.clear();
    is_too_coarse_ = false;
    if (!sampling_) sampling_ = source.sampling<m>(*manifold_, progress);
    try {
      take_net(sampling_ ? sampling_->complete(progress) : source.charts<m>(*manifold_, progress), progress);
    } catch (const TooCoarse& error) {
      failed_ = error.places;
      is_too_coarse_ = true;
      throw;
    } catch (const UncoveredPart&) {
      is_too_coarse_ = true;
      throw;
    }
    report.patch_factor = this->atlas_->patch_factor();
    report.parameters.algorithm.separation = measure_separation<m>(*this->atlas_);
  }

  [[nodiscard]] NetText net() const override {
    PointList centres;
    for (const TangentChart& chart : this->atlas_->charts()) centres.push_back(chart.data().centre);
    return {centres, "coordinates of the space around, near the manifold"};
  }

  void choose_parameters(const CertifyOptions& options, const Progress&) override {
    refuse_theory_mode(options, "a submanifold");
    this->choose_measured_parameters(options);
  }

  void derive(const LevelSelection& selection, const Progress& progress) override {
    const auto& run = *this->run_;
    const SubmanifoldMeasures<m> measures = measure_submanifold<m>(*this->atlas_, run, geometry(), selection, progress);
    report.claims = derive_claims<m>(*this->atlas_, report.parameters, run, measures, selection, report.reasons);
    report.stability = measures.stability;
    report.graphs->reach = measures.reach;
    for (const auto& failure : measures.triangulation.failures) {
      for (const std::uint32_t label : failure.simplex) failed_.push_back(place_of(Label(label)));
    }
    fails_at_level_5_ = !failed_.empty();
    if (measures.isotopy) {
      report.graphs->margin = measures.isotopy->margin;
      if (!measures.isotopy->holds()) {
        for (const Label label : measures.isotopy->crowded) failed_.push_back(place_of(label));
      }
    }
    this->require_homology(manifold_->homology());
    is_too_coarse_ = selects(selection, "5") && !measures.triangulation.triangulates();
  }

  [[nodiscard]] std::optional<FailedRound> refine() override {
    if (!sampling_) return std::nullopt;
    const bool has_failing_stars = this->run_ && !this->run_->is_certified();
    if (has_failing_stars) {
      for (const Label label : this->run_->agreement.labels) failed_.push_back(place_of(label));
      for (const StarFailure& failure : this->run_->star_failures) failed_.push_back(place_of(failure.label));
    }
    if (failed_.empty()) return std::nullopt;
    sampling_->refine(failed_);
    const char* stage = !this->run_         ? "charts"
                        : has_failing_stars ? "stars"
                        : fails_at_level_5_ ? "level 5"
                                            : "level 5i";
    return FailedRound{stage, std::set(failed_.begin(), failed_.end()).size(), this->run_ ? this->atlas_->size() : 0};
  }

  [[nodiscard]] std::string advice(const NetSource& source, const Progress& progress) const override {
    const bool has_failed = is_too_coarse_ || (this->run_ && !this->run_->is_certified());
    if (!sampling_ || !has_failed) return {};
    const auto radii = advise_radius(*manifold_, *source.radius, source.sizing.text, failed_, source.seed, progress);
    return radii ? "; for the whole manifold " + radii->text() : "";
  }

  void write(const std::string& path, const Progress& progress) const override {
    write_certificate<m>(path, content_of<m>(*this->atlas_, report.parameters, *this->run_, report.claims), progress);
  }

 private:
  void take_net(SubmanifoldNet<m> net, const Progress& progress) {
    report.graphs->slope = net.charts.slope;
    report.graphs->distortion = distortion_of_slope(net.charts.slope);
    report.graphs->cover_parts = net.parts;
    report.radii.reset();
    if (net.radii.vary())
      report.radii = radii_report(net.radii, radius_variation(net.charts.charts, net.radii), Dimension(m), "6 ε_i");
    this->take_atlas(SubmanifoldAtlas<m>(manifold_, std::move(net.charts), std::move(net.radii), progress));
  }
  [[nodiscard]] std::vector<double> place_of(Label i) const {
    std::vector<double> result;
    for (const Rational& x : this->atlas_->chart(i).data().centre) result.push_back(approximate_double(x));
    return result;
  }

  [[nodiscard]] ModelGeometry geometry() const override { return geometry_of<m>(*this->atlas_); }
  [[nodiscard]] bool repairs_stability() const override { return true; }

  std::shared_ptr<const EmbeddedManifold> manifold_;
  std::unique_ptr<SubmanifoldSampling<m>> sampling_;  // none for points that are given
  std::vector<std::vector<double>> failed_;           // where radii are too large
  bool fails_at_level_5_ = false;
  bool is_too_coarse_ = false;  // the net: charts, or simplices that are to be mapped to M
};

}  // namespace

std::unique_ptr<Family> family_of(const SubmanifoldDescription& manifold) {
  if (manifold.dimension == Dimension(1)) return std::make_unique<SubmanifoldFamily<1>>(manifold);
  if (manifold.dimension == Dimension(2)) return std::make_unique<SubmanifoldFamily<2>>(manifold);
  return std::make_unique<SubmanifoldFamily<3>>(manifold);
}

}  // namespace delcert
