#include "proofs/certification/certification.hpp"

#include <fmt/format.h>

#include "kernel/parallel/threads.hpp"
#include "proofs/certification/family.hpp"
#include "proofs/certification/report_parts.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// One certification: again with smaller radii, as often as that is allowed.
class Certification {
 public:
  Certification(CertifyOptions options, const Progress& progress)
      : options_(std::move(options)),
        progress_(clock_.callback([this, progress](std::string_view stage, std::size_t done, std::size_t total) {
          refinement_.size() == 0 ? progress(stage, done, total)
                                  : progress(refinement_.text() + "; " + std::string(stage), done, total);
        })) {
    options_.choice.seed = options_.source.seed;
    if (options_.no_perturbation) options_.choice.mode = RunMode::none;
    const AnyManifold manifold = find_any_manifold(options_.source.manifold);
    family_ = options_.complex.empty() ? family_of(manifold, clock_) : family_of_mesh(manifold, options_.complex);
  }

  RunReport report() {
    RunReport& report = family_->report;
    for (int round = 0;; ++round) {
      try {
        attempt();
        if (!is_refined(round)) break;
      } catch (const Rejection& rejection) {
        if (!is_refined(round)) refuse(rejection);
      } catch (const Undecided& undecided) {
        throw Undecided(undecided.what() + advice());
      }
      report.refinement_rounds = round + 1;
    }
    if (refinement_.has_stalled()) report.reasons.push_back(refinement_.reason());
    for (std::string& reason : report.reasons) {
      if (reason.starts_with("level 5:")) reason += advice();
    }
    if (report.claims.names().empty())
      throw Rejection(fmt::format("no level is reached: {}", fmt::join(report.reasons, "; ")));
    clock_.begin("write the certificate");
    report.certificate = options_.output.empty() ? report.manifold + ".delcert.json.zst" : options_.output;
    family_->write(report.certificate, progress_);
    report.stages = clock_.finish();
    report.peak_memory_mib = peak_memory_in_mib();
    RunReport result = std::move(report);
    result.made_from = std::move(family_);
    return result;
  }

 private:
  /// Whether radii have become smaller for another round.
  bool is_refined(int round) {
    if (round == options_.refinement_rounds) return false;
    auto failed = family_->refine();
    if (!failed) return false;
    refinement_.add(std::move(*failed));
    return !refinement_.has_stalled();
  }
  [[noreturn]] void refuse(const Rejection& rejection) {
    if (refinement_.has_stalled())
      throw Undecided(std::string(rejection.what()) + "; " + refinement_.reason() + advice());
    throw Rejection(rejection.what() + advice());
  }
  [[nodiscard]] std::string advice() const { return family_->advice(options_.source, progress_); }

  void attempt() {
    RunReport& report = family_->report;
    clock_.begin("read or sample the net");
    family_->make_net(options_.source, progress_);
    family_->choose_parameters(options_, progress_);
    report.parameters.origin = options_.origin;

    RunRequest request;
    request.perturb = !options_.no_perturbation;
    request.most_repair_rounds = options_.repair_rounds;
    request.repair_stability = selects(options_.levels, "2s");
    if (options_.required_protection)
      request.required_protection = *options_.required_protection * report.sampling_radius;
    family_->run(request, progress_);

    clock_.begin("derive levels");
    report.reasons.clear();
    family_->derive(options_.levels, progress_);
  }

  CertifyOptions options_;
  StageClock clock_;
  Refinement refinement_;
  Progress progress_;
  std::unique_ptr<Family> family_;
};

}  // namespace

RunReport certified_run(const CertifyOptions& options, const Progress& progress) {
  const ThreadLimit limit(options.threads);
  return Certification(options, progress).report();
}

}  // namespace delcert
