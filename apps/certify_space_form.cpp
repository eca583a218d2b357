#include "apps/certify_space_form.hpp"

#include <fmt/format.h>

#include <iostream>

#include "apps/chart_run.hpp"
#include "apps/distortion_report.hpp"
#include "apps/progress_line.hpp"
#include "apps/report_parts.hpp"
#include "apps/space_form_report.hpp"
#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/sample/separation.hpp"
#include "proofs/certificate/content.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// What the theorems of the paper ask of a curved manifold, in place of a run.
[[noreturn]] void refuse_theory(const Rational& separation, int dimension, const MeasuredNet& net) {
  throw Rejection(theory_refusal(constants_for(Dimension(dimension), separation, separation / Rational(4)), net));
}

template <int m>
ExitStatus certify(const CertifyOptions& options, SpaceForm form, ProgressLine& line, StageClock& clock,
                   const Progress& progress) {
  SpaceFormReport report;
  report.manifold = form.description.name;
  report.curvature = form.form().curvature();
  report.injectivity_radius = form.injectivity_radius.lower;
  report.first_homology = group_text(form.first_homology);
  clock.begin("read or sample the net");
  auto [centres, sampling_radius] = options.source.template net_of<m>(form, progress);
  report.patch_factor = fitting_patch_factor(form, m, sampling_radius);
  const SpaceFormAtlas<m> atlas(std::move(form), std::move(centres), sampling_radius, report.patch_factor);
  const Rational separation = measure_separation<m>(atlas, progress);
  report.points = atlas.size();
  report.sampling_radius = sampling_radius;
  if (options.mode_is_given && options.choice.mode == RunMode::theory && atlas.curvature() != Curvature::zero)
    refuse_theory(separation, m, {sign_of(report.curvature), report.injectivity_radius, sampling_radius, atlas.size()});
  report.parameters = measured_run_parameters(options, Dimension(m), separation);

  const RunRequest request = run_request(options, sampling_radius);
  const ChartRun<m> run = run_in_charts<m>(atlas, report.parameters.algorithm, request, progress);
  line.clear();
  require_certified<m>(run);

  clock.begin("derive levels");
  report.measures = measure_run<m>(atlas, run, progress);
  report.claims = derive_claims<m>(atlas, report.parameters, run, report.measures, options.levels, report.reasons);
  if (report.claims.names().empty())
    throw Rejection("no level is reached: " + fmt::format("{}", fmt::join(report.reasons, "; ")));
  report.distortion = measure_distortion<m>(atlas, report.parameters, report.claims);
  clock.begin("write the certificate");
  report.certificate = options.output.empty() ? report.manifold + ".delcert.json.zst" : options.output;
  write_certificate<m>(report.certificate, content_of<m>(atlas, report.parameters, run, report.claims), progress);

  report.take<m>(run);
  report.stages = clock.finish();
  report.peak_memory_mib = peak_memory_in_mib();
  line.clear();
  std::cout << (options.json ? report_json(report) : report_text(report));
  return ExitStatus::verified;
}

}  // namespace

ExitStatus certify_space_form(const CertifyOptions& options, const SpaceFormDescription& description) {
  ProgressLine line;
  StageClock clock;
  const Progress progress = clock.callback(line.callback());
  clock.begin("verify the group");
  SpaceForm form = verify_space_form(description);
  if (form.form().dimension() == 2) return certify<2>(options, std::move(form), line, clock, progress);
  return certify<3>(options, std::move(form), line, clock, progress);
}

}  // namespace delcert
