#include "kernel/sample/separation.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/metric_field_claims.hpp"
#include "proofs/certification/chart_family.hpp"

namespace delcert {

namespace {

/// Riemannian metrics on a torus, by formulas.
template <int m>
class MetricFieldFamily final : public ChartFamily<m, MetricFieldAtlas<m>> {
 public:
  using Family::report;

  explicit MetricFieldFamily(const MetricFieldDescription& manifold)
      : ChartFamily<m, MetricFieldAtlas<m>>(false), field_(manifold) {
    report.manifold = manifold.name;
    report.family = "metric-field";
    report.dimension = Dimension(m);
    report.metric = RunReport::Metric{field_.eigenvalue_bounds(), {}};
  }

  void make_net(const NetSource& source, const Progress& progress) override {
    auto centres = source.centres<m>(field_, progress);  // first: refuses a source without a radius
    this->take_atlas(MetricFieldAtlas<m>(field_, std::move(centres), *source.radius));
    report.parameters.algorithm.separation = measure_separation<m>(*this->atlas_);
  }

  [[nodiscard]] NetText net() const override { return {this->centres(), "coordinates of the torus"}; }

  void choose_parameters(const CertifyOptions& options, const Progress& progress) override {
    refuse_theory_mode(options, "a metric field");
    report.metric->distortion = fit_patches<m>(*this->atlas_, progress);
    report.patch_factor = this->atlas_->patch_factor();
    this->choose_measured_parameters(options);
  }

  void derive(const LevelSelection& selection, const Progress& progress) override {
    const MetricFieldMeasures measures{
        check_stability<m>(*this->atlas_, this->run_->points, geometry(), this->run_->complex, progress),
        check_affine_triangulation<m>(*this->atlas_, this->run_->points, this->run_->complex)};
    report.claims = derive_claims<m>(*this->atlas_, report.parameters, report.metric->distortion, *this->run_, measures,
                                     selection, report.reasons);
    report.stability = measures.stability;
  }

  void write(const std::string& path, const Progress& progress) const override {
    write_certificate<m>(
        path, content_of<m>(*this->atlas_, report.metric->distortion, report.parameters, *this->run_, report.claims),
        progress);
  }

 private:
  [[nodiscard]] ModelGeometry geometry() const override {
    return geometry_of<m>(*this->atlas_, report.metric->distortion);
  }

  MetricField<m> field_;
};

}  // namespace

std::unique_ptr<Family> family_of(const MetricFieldDescription& manifold) {
  if (manifold.dimension == Dimension(2)) return std::make_unique<MetricFieldFamily<2>>(manifold);
  return std::make_unique<MetricFieldFamily<3>>(manifold);
}

}  // namespace delcert
