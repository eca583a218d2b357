#pragma once

#include "kernel/sample/metric_field_net.hpp"
#include "kernel/sample/separation.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/metric_field_claims.hpp"
#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {

/// A certified run on a metric field, with everything that goes into its certificate.
template <int m>
struct MetricFieldSample {
  MetricFieldAtlas<m> atlas;
  ChartDistortion distortion;
  RunParameters parameters;
  ChartRun<m> run;
  MetricFieldMeasures measures;

  [[nodiscard]] Claims claims(std::vector<std::string>& reasons, const LevelSelection& levels = all_levels()) const {
    return derive_claims<m>(atlas, parameters, distortion, run, measures, levels, reasons);
  }
  void write(const std::filesystem::path& path, const Claims& some) const {
    write_certificate<m>(path, content_of<m>(atlas, distortion, parameters, run, some));
  }
};

template <int m>
MetricFieldSample<m> certified_run(const MetricFieldDescription& description, const Rational& radius) {
  MetricField<m> field(description);
  auto net = metric_field_net<m>(field, radius, 1, no_progress());
  MetricFieldAtlas<m> atlas(std::move(field), std::move(net.centres), radius);
  const auto distortion = fit_patches<m>(atlas, no_progress());
  ParameterChoice choice;
  choice.mode = RunMode::measured;
  const auto usual = measured_parameters(Dimension(m), 1);
  choice.tolerance = usual.tolerance;
  auto parameters = parameters_for(Dimension(m), measure_separation<m>(atlas), choice);
  parameters.algorithm.clearance = usual.clearance;
  parameters.algorithm.choices = usual.choices;
  RunRequest request;
  request.certify_model = false;
  const auto geometry = geometry_of<m>(atlas, distortion);
  auto run = run_in_charts<m>(atlas, geometry, parameters.algorithm, request, no_progress());
  MetricFieldMeasures measures{check_stability<m>(atlas, run.points, geometry, run.complex, no_progress()),
                               check_affine_triangulation<m>(atlas, run.points, run.complex)};
  return {std::move(atlas), distortion, parameters, std::move(run), std::move(measures)};
}

/// Some 400 points on a sheared torus, made once.
[[nodiscard]] inline const MetricFieldSample<2>& sheared_run() {
  static const auto run = certified_run<2>(shear(), ratio(1, 20));
  return run;
}

/// In a constant metric, made once.
[[nodiscard]] inline const MetricFieldSample<2>& flat_run() {
  static const auto run =
      certified_run<2>(constant_field({{Rational(1), ratio(1, 3)}, {ratio(1, 3), Rational(2)}}), ratio(1, 20));
  return run;
}

/// In a metric that varies so little that charts show which simplices are Delaunay for its distance; made once.
[[nodiscard]] inline const MetricFieldSample<2>& nearly_flat_run() {
  static const auto run = certified_run<2>(hills(2, ratio(1, 10000)), ratio(1, 20));
  return run;
}

}  // namespace delcert::test
