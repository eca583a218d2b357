#pragma once

#include <optional>
#include <string_view>

#include "kernel/chart/length_units.hpp"
#include "kernel/run/chart_run.hpp"
#include "proofs/certification/family.hpp"
#include "support/error.hpp"

namespace delcert {

/// Measured mode with what suits this dimension, where nothing else is asked for; `vary`: whether sampling radii do.
[[nodiscard]] inline ParameterChoice choice_in_charts(Dimension dimension, const CertifyOptions& options, bool vary) {
  ParameterChoice choice = options.choice;
  choice.mode = options.no_perturbation ? RunMode::none : RunMode::measured;
  if (!options.no_perturbation && !choice.tolerance) {
    choice.tolerance = measured_parameters(dimension, choice.seed).tolerance;
    // Where radii vary, there are more candidates.
    if (vary) choice.tolerance = *choice.tolerance / Rational(2);
  }
  return choice;
}

/// Throws Rejection where the paper's constants are asked for. `kind`: "a submanifold".
inline void refuse_theory_mode(const CertifyOptions& options, std::string_view kind) {
  if (!options.mode_is_given || options.choice.mode != RunMode::theory) return;
  throw Rejection("mode theory on " + std::string(kind) +
                  ": charts are distorted, and the paper's constants ask for far less; use --mode measured");
}

/// What is done alike wherever a manifold is seen through charts, on space forms and on metric fields.
template <int m, class ChartAtlas>
class ChartFamily : public Family {
 public:
  void run(RunRequest request, const Progress& progress) override {
    request.certify_model = certifies_model_;
    request.repair_stability = request.repair_stability && repairs_stability();
    request_ = request;
    run_.emplace(run_in_charts<m>(*atlas_, geometry(), report.parameters.algorithm, request, progress));
    report.take(*run_);
    report.first = RunReport::FirstStars{run_->first_failures, run_->first_agreement.stars};
    if (!run_->is_certified()) {
      refuse_stars({run_->star_failures, run_->agreement.failures, run_->model.failures}, run_->agreement.labels);
    }
  }

 protected:
  explicit ChartFamily(bool certifies_model) : certifies_model_(certifies_model) {}

  [[nodiscard]] virtual ModelGeometry geometry() const = 0;
  /// Whether points are placed anew for the sake of level 2s.
  [[nodiscard]] virtual bool repairs_stability() const { return false; }

  /// In measured mode, with what suits this dimension.
  void choose_measured_parameters(const CertifyOptions& options) {
    const ParameterChoice choice = choice_in_charts(Dimension(m), options, LengthUnits(*atlas_).vary());
    report.parameters = parameters_for(Dimension(m), report.parameters.algorithm.separation, choice);
  }

  void take_atlas(ChartAtlas atlas) {
    atlas_.emplace(std::move(atlas));
    report.points = atlas_->size();
    report.sampling_radius = atlas_->sampling_radius();
  }
  [[nodiscard]] PointList centres() const {
    PointList result;
    for (std::uint32_t index = 0; index < atlas_->size(); ++index) {
      const auto& centre = atlas_->centre(Label(index));
      result.emplace_back(centre.begin(), centre.end());
    }
    return result;
  }

  std::optional<ChartAtlas> atlas_;
  std::optional<ChartRun<m>> run_;
  RunRequest request_;

 private:
  bool certifies_model_;
};

}  // namespace delcert
