#include "apps/certification.hpp"

#include <fmt/format.h>

#include <iostream>

#include "apps/family.hpp"
#include "apps/progress_line.hpp"
#include "apps/report_parts.hpp"
#include "support/error.hpp"

namespace delcert {

ExitStatus certify(const CertifyOptions& options) {
  ProgressLine line;
  StageClock clock;
  const Progress progress = clock.callback(line.callback());
  const AnyManifold manifold = find_any_manifold(options.source.manifold);
  const std::unique_ptr<Family> family =
      options.complex.empty() ? family_of(manifold, clock) : family_of_mesh(manifold, options.complex);
  RunReport& report = family->report;
  const auto attempt = [&] {
    clock.begin("read or sample the net");
    family->make_net(options.source, progress);
    family->choose_parameters(options, progress);
    report.parameters.origin = options.origin;

    RunRequest request;
    request.perturb = !options.no_perturbation;
    request.most_repair_rounds = options.repair_rounds;
    if (options.required_protection)
      request.required_protection = *options.required_protection * report.sampling_radius;
    family->run(request, progress);
    line.clear();

    clock.begin("derive levels");
    report.reasons.clear();
    family->derive(options.levels, progress);
  };
  for (int round = 0;; ++round) {
    const bool is_last = round == options.refinement_rounds;
    try {
      attempt();
      if (is_last || !family->refine()) break;
    } catch (const Rejection&) {
      if (is_last || !family->refine()) throw;
    }
    report.refinement_rounds = round + 1;
  }
  if (report.claims.names().empty())
    throw Rejection(fmt::format("no level is reached: {}", fmt::join(report.reasons, "; ")));
  clock.begin("write the certificate");
  report.certificate = options.output.empty() ? report.manifold + ".delcert.json.zst" : options.output;
  family->write(report.certificate, progress);

  report.stages = clock.finish();
  report.peak_memory_mib = peak_memory_in_mib();
  line.clear();
  std::cout << (options.json ? report_json(report) : report_text(report));
  return ExitStatus::verified;
}

}  // namespace delcert
