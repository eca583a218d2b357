#include "apps/certify_metric_field.hpp"

#include <fmt/format.h>

#include <iostream>

#include "apps/chart_run.hpp"
#include "apps/metric_field_net.hpp"
#include "apps/metric_field_report.hpp"
#include "apps/progress_line.hpp"
#include "apps/report_parts.hpp"
#include "kernel/sample/separation.hpp"
#include "proofs/certificate/content.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

template <int m>
ExitStatus certify(const CertifyOptions& options, const MetricFieldDescription& description) {
  if (options.mode_is_given && options.choice.mode == RunMode::theory) {
    throw Rejection(
        "mode theory on a metric field: charts are distorted, and the paper's constants ask for far less; "
        "use --mode measured");
  }
  ProgressLine line;
  StageClock clock;
  const Progress progress = clock.callback(line.callback());
  MetricFieldReport report;
  report.manifold = description.name;
  clock.begin("verify the metric");
  MetricField<m> field(description);
  report.eigenvalues = field.eigenvalue_bounds();
  clock.begin("read or sample the net");
  auto centres = metric_field_net_of<m>(options.source, field, progress);
  MetricFieldAtlas<m> atlas(std::move(field), std::move(centres), *options.source.radius);
  clock.begin("measure the charts");
  report.distortion = fit_patches<m>(atlas, progress);
  report.patch_factor = atlas.patch_factor();
  const Rational separation = measure_separation<m>(atlas);
  report.points = atlas.size();
  report.sampling_radius = atlas.sampling_radius();
  report.parameters = measured_run_parameters(options, Dimension(m), separation);

  RunRequest request = run_request(options, atlas.sampling_radius());
  request.certify_model = false;
  const ModelGeometry geometry = geometry_of<m>(atlas, report.distortion);
  const ChartRun<m> run = run_in_charts<m>(atlas, geometry, report.parameters.algorithm, request, progress);
  line.clear();
  require_certified<m>(run);

  clock.begin("derive levels");
  report.measures = {check_stability<m>(atlas, run.points, geometry, run.complex, progress),
                     check_affine_triangulation<m>(atlas, run.points, run.complex)};
  report.claims = derive_claims<m>(atlas, report.parameters, report.distortion, run, report.measures, options.levels,
                                   report.reasons);
  if (report.claims.names().empty())
    throw Rejection("no level is reached: " + fmt::format("{}", fmt::join(report.reasons, "; ")));
  clock.begin("write the certificate");
  report.certificate = options.output.empty() ? report.manifold + ".delcert.json.zst" : options.output;
  write_certificate<m>(report.certificate,
                       content_of<m>(atlas, report.distortion, report.parameters, run, report.claims), progress);

  report.take<m>(run);
  report.stages = clock.finish();
  report.peak_memory_mib = peak_memory_in_mib();
  line.clear();
  std::cout << (options.json ? report_json(report) : report_text(report));
  return ExitStatus::verified;
}

}  // namespace

ExitStatus certify_metric_field(const CertifyOptions& options, const MetricFieldDescription& description) {
  if (description.dimension == Dimension(2)) return certify<2>(options, description);
  return certify<3>(options, description);
}

}  // namespace delcert
