#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/sample/separation.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/space_form_claims.hpp"
#include "proofs/certification/chart_family.hpp"
#include "proofs/certification/distortion_report.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Quotients of a sphere, of Euclidean and of hyperbolic space.
template <int m>
class SpaceFormFamily final : public ChartFamily<m, SpaceFormAtlas<m>> {
 public:
  using Family::report;

  explicit SpaceFormFamily(SpaceForm form) : ChartFamily<m, SpaceFormAtlas<m>>(true), form_(std::move(form)) {
    const Curvature curvature = form_.form().curvature();
    report.manifold = form_.description.name;
    report.family = family_of(curvature);
    report.dimension = Dimension(m);
    report.group =
        RunReport::Group{sign_of(curvature), form_.injectivity_radius.lower, group_text(form_.first_homology)};
  }

  void make_net(const NetSource& source, const Progress& progress) override {
    auto [centres, sampling_radius] = source.net_of<m>(form_, progress);
    const int factor = fitting_patch_factor(form_, m, sampling_radius);
    report.patch_factor = factor;
    this->take_atlas(SpaceFormAtlas<m>(form_, std::move(centres), sampling_radius, factor));
    report.parameters.algorithm.separation = measure_separation<m>(*this->atlas_, progress);
  }

  [[nodiscard]] NetText net() const override {
    std::vector<Vector<Rational, m>> centres;
    for (std::uint32_t index = 0; index < this->atlas_->size(); ++index)
      centres.push_back(this->atlas_->centre(Label(index)));
    return {this->centres(),
            "conformal coordinates",
            {},
            measured_net<m>(form_, centres, report.sampling_radius).covering_radius};
  }

  void choose_parameters(const CertifyOptions& options, const Progress&) override {
    const Rational separation = report.parameters.algorithm.separation;
    if (options.mode_is_given && options.choice.mode == RunMode::theory && report.group->curvature != 0) {
      throw Rejection(theory_refusal(
          constants_for(Dimension(m), separation, separation / Rational(4)),
          {report.group->curvature, report.group->injectivity_radius, report.sampling_radius, report.points}));
    }
    this->choose_measured_parameters(options);
  }

  void derive(const LevelSelection& selection, const Progress& progress) override {
    const SpaceFormMeasures measures = measure_run<m>(*this->atlas_, *this->run_, progress);
    report.claims =
        derive_claims<m>(*this->atlas_, report.parameters, *this->run_, measures, selection, report.reasons);
    report.stability = measures.stability;
    report.flat = measures.flat;
    report.riemannian = measures.simplices;
    report.distortion = measure_distortion<m>(*this->atlas_, report.parameters, report.claims);
  }

  void write(const std::string& path, const Progress& progress) const override {
    write_certificate<m>(path, content_of<m>(*this->atlas_, report.parameters, *this->run_, report.claims), progress);
  }

 private:
  [[nodiscard]] ModelGeometry geometry() const override { return geometry_of<m>(*this->atlas_); }

  SpaceForm form_;
};

}  // namespace

std::unique_ptr<Family> family_of(const SpaceFormDescription& manifold) {
  SpaceForm form = verify_space_form(manifold);
  if (form.form().dimension() == 2) return std::make_unique<SpaceFormFamily<2>>(std::move(form));
  return std::make_unique<SpaceFormFamily<3>>(std::move(form));
}

}  // namespace delcert
