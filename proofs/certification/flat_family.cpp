#include <fmt/format.h>

#include "kernel/sample/graded_density.hpp"
#include "kernel/sample/net_measure.hpp"
#include "kernel/sample/separation.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/flat_claims.hpp"
#include "proofs/certification/family.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Flat tori and Euclidean balls.
template <int m>
class FlatFamily final : public Family {
 public:
  explicit FlatFamily(ManifoldDescription manifold)
      : manifold_(std::move(manifold)), space_(flat_space_of<m>(manifold_)) {
    report.manifold = manifold_.name;
    report.family = name_of(manifold_.family);
    report.dimension = Dimension(m);
  }

  void make_net(const NetSource& source, const Progress& progress) override {
    const auto sizing = source.torus_sizing<m>(space_);
    auto made = source.net<m>(space_, progress);
    PointSet<m> net(std::move(made.points));
    if (sizing) {
      take_graded(std::move(net), *sizing, progress);
    } else {
      NetDensity<m> density = measure_density<m>(space_, net, source.radius, progress, made.simplices);
      covering_radius_lower_ = density.covering_radius_lower;
      net_simplices_ = std::move(density.simplices);
      atlas_.emplace(space_, std::move(net), density.sampling_radius);
    }
    report.points = atlas_->size();
    report.sampling_radius = atlas_->sampling_radius();
    // Points are μ₀ε_i apart in all patches if they are μ₀(1 + ε₀) times the lesser radius apart.
    const Rational separation = measure_separation<m>(*atlas_) / (Rational(1) + atlas_->radius_variation());
    report.parameters.algorithm.separation = atlas_->radii().vary() ? rounded_down(separation, -20) : separation;
  }

  [[nodiscard]] NetText net() const override {
    NetText result{{}, "", covering_radius_lower_};
    for (std::uint32_t index = 0; index < atlas_->size(); ++index) {
      const auto& point = atlas_->net().exact(Label(index));
      result.points.emplace_back(point.begin(), point.end());
    }
    return result;
  }

  void choose_parameters(const CertifyOptions& options, const Progress&) override {
    const Rational separation = report.parameters.algorithm.separation;
    report.parameters = parameters_for(Dimension(m), separation, options.choice, atlas_->radius_variation());
    report.input = check_input<m>(*atlas_, separation, report.parameters.algorithm.perturbation);
    std::string failed;
    for (const InputItem& item : report.input) {
      if (!is_proved(item.verdict))
        failed += fmt::format("\n  {} {} ({})", name_of(item.verdict), item.name, item.detail);
    }
    if (!failed.empty()) throw Rejection("the input does not satisfy Hypotheses 1:" + failed);
  }

  void run(RunRequest request, const Progress& progress) override {
    run_.emplace(run_algorithm<m>(*atlas_, report.parameters.algorithm, request, progress));
    report.take(*run_);
    if (!run_->is_certified()) refuse_stars({run_->protection.failures, run_->combinatorial_failures});
  }

  void derive(const LevelSelection& selection, const Progress& progress) override {
    report.claims = derive_claims<m>(*atlas_, report.parameters, *run_, selection, progress, report.reasons);
  }

  void write(const std::string& path, const Progress& progress) const override {
    write_certificate<m>(
        path, content_of<m>(manifold_, *atlas_, net_simplices_, report.parameters, *run_, report.claims), progress);
  }

 private:
  void take_graded(PointSet<m> net, const TorusSizing<m>& sizing, const Progress& progress) {
    std::vector<double> radii;
    for (const auto& point : net.approximate_all()) radii.push_back(sizing.at(point));
    GradedDensity<m> density = measure_graded_density<m>(space_, net, SamplingRadii(radii), progress);
    if (density.radii.vary())
      report.radii = radii_report(density.radii, density.radius_variation, Dimension(m), "9(1 + ε₀) ε_i");
    net_simplices_ = std::move(density.simplices);
    atlas_.emplace(space_, std::move(net), std::move(density.radii), std::move(density.radius_variation));
  }

  ManifoldDescription manifold_;
  FlatSpace<m> space_;
  std::vector<LiftedSimplex<m>> net_simplices_;
  std::optional<Rational> covering_radius_lower_;  // none where radii vary
  std::optional<FlatAtlas<m>> atlas_;
  std::optional<RunResult<m>> run_;
};

}  // namespace

std::unique_ptr<Family> family_of(const ManifoldDescription& manifold) {
  return with_dimension(manifold.dimension,
                        [&]<int m>() -> std::unique_ptr<Family> { return std::make_unique<FlatFamily<m>>(manifold); });
}

}  // namespace delcert
