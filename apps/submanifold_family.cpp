#include <fmt/format.h>

#include "apps/chart_family.hpp"
#include "apps/report_parts.hpp"
#include "kernel/sample/separation.hpp"
#include "kernel/topology/abelian_group.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/submanifold_claims.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Zero sets of equations, in tangent charts.
template <int m>
class SubmanifoldFamily final : public ChartFamily<m, SubmanifoldAtlas<m>> {
 public:
  using Family::report;

  explicit SubmanifoldFamily(const SubmanifoldDescription& manifold)
      : ChartFamily<m, SubmanifoldAtlas<m>>(false), zero_set_(manifold) {
    report.manifold = manifold.name;
    report.family = "submanifold";
    report.dimension = Dimension(m);
    report.graphs.emplace();
    report.graphs->ambient_dimension = zero_set_.ambient();
  }

  void make_net(const NetSource& source, const Progress& progress) override {
    SubmanifoldNet<m> net = source.charts<m>(zero_set_, progress);
    report.graphs->slope = net.charts.slope;
    report.graphs->distortion = distortion_of_slope(net.charts.slope);
    report.graphs->cover_parts = net.parts;
    this->take_atlas(SubmanifoldAtlas<m>(zero_set_, std::move(net.charts), *source.radius, progress));
    report.patch_factor = this->atlas_->patch_factor();
    report.parameters.algorithm.separation = measure_separation<m>(*this->atlas_);
  }

  [[nodiscard]] NetText net() const override {
    PointList centres;
    for (const TangentChart& chart : this->atlas_->charts()) centres.push_back(chart.data().centre);
    return {centres, "coordinates of the space around, near the manifold"};
  }

  void choose_parameters(const CertifyOptions& options, const Progress&) override {
    if (options.mode_is_given && options.choice.mode == RunMode::theory) {
      throw Rejection(
          "mode theory on a submanifold: charts are distorted, and the paper's constants ask for far less; "
          "use --mode measured");
    }
    this->choose_measured_parameters(options);
  }

  void derive(const LevelSelection& selection, const Progress& progress) override {
    const auto& run = *this->run_;
    const SubmanifoldMeasures<m> measures = measure_submanifold<m>(*this->atlas_, run, geometry(), selection, progress);
    report.claims = derive_claims<m>(*this->atlas_, report.parameters, run, measures, selection, report.reasons);
    report.stability = measures.stability;
    if (measures.triangulation.triangulates()) report.graphs->margin = measures.triangulation.margin;
    require_homology();
  }

  void write(const std::string& path, const Progress& progress) const override {
    write_certificate<m>(path, content_of<m>(*this->atlas_, report.parameters, *this->run_, report.claims), progress);
  }

 private:
  [[nodiscard]] ModelGeometry geometry() const override { return geometry_of<m>(*this->atlas_); }

  /// What the file says of the homology is so.
  void require_homology() const {
    const std::vector<std::string>& said = zero_set_.description().homology;
    if (said.empty() || !report.claims.manifold) return;
    const std::vector<std::string> found = homology_texts(*report.claims.manifold);
    if (found != said) {
      throw Rejection(fmt::format("the homology is {}, and not {} as the file says", fmt::join(found, ", "),
                                  fmt::join(said, ", ")));
    }
  }

  ZeroSet zero_set_;
};

}  // namespace

std::unique_ptr<Family> family_of(const SubmanifoldDescription& manifold) {
  if (manifold.dimension == Dimension(2)) return std::make_unique<SubmanifoldFamily<2>>(manifold);
  return std::make_unique<SubmanifoldFamily<3>>(manifold);
}

}  // namespace delcert
