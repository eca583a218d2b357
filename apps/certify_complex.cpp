#include "apps/certify_complex.hpp"

#include <unistd.h>

#include <filesystem>
#include <iostream>

#include "apps/checker_process.hpp"
#include "apps/complex_report.hpp"
#include "apps/progress_line.hpp"
#include "proofs/certificate/file_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace fs = std::filesystem;

namespace {

/// A certificate that nobody has verified yet: beside the one that it may become, and removed unless it does.
class Proposal {
 public:
  explicit Proposal(const fs::path& certificate)
      : certificate_(certificate),
        path_(certificate.parent_path() /
              (".unverified-" + std::to_string(getpid()) + "-" + certificate.filename().string())) {}
  ~Proposal() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  Proposal(const Proposal&) = delete;
  Proposal& operator=(const Proposal&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }
  void accept() const { fs::rename(path_, certificate_); }

 private:
  fs::path certificate_, path_;
};

/// What delcert-check says of the proposal, if that is "verified".
CheckerRun verified(const ComplexDescription& complex, const Proposal& proposal) {
  CheckerRun run = run_checker_on(installed_checker(), proposal.path());
  if (run.status > 3) throw std::runtime_error("delcert-check ended with status " + std::to_string(run.status));
  const std::string findings = findings_text(complex, run.output);
  if (run.status == 2) throw Undecided(complex.name + ": delcert-check cannot decide it:" + findings);
  if (run.status != 0 || !findings.empty())
    throw Rejection(complex.name + " is not certified; delcert-check found" + findings);
  return run;
}

std::string listed(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : ", ") + name;
  return result;
}

template <int m>
ExitStatus certify(const CertifyCommand& options, const ComplexDescription& complex, ProgressLine& line,
                   StageClock& clock, const Progress& progress) {
  clock.begin("place simplices, search for loops");
  const GivenComplex<m> given = place_complex<m>(complex);
  clock.begin("measure circumballs");
  // Without its generators the complex may be broken elsewhere: that is said first.
  const bool has_loops = given.without_loop.empty();
  ComplexReport report;
  report.claims = claims_of<m>(complex.form, given, has_loops ? options.levels : LevelSelection{"2"}, progress);
  for (std::string& reason : report.claims.not_reached) reason = in_names_of(complex, reason);
  clock.begin("write the certificate");
  report.certificate = options.output.empty() ? complex.name + ".delcert.json.zst" : options.output;
  const Proposal proposal(report.certificate);
  write_given_complex<m>(proposal.path(), complex, given, report.claims, options.origin, progress);
  clock.begin("delcert-check");
  report.checker = verified(complex, proposal).output;
  if (!has_loops) {
    throw Rejection(complex.name + ": the group of the complex does not seem to contain " + listed(given.without_loop) +
                    ": no closed path of edges along it was found among the nearest places");
  }
  proposal.accept();

  report.manifold = complex.name;
  report.dimension = m;
  report.curvature = complex.form.curvature();
  report.points = given.points.size();
  report.generators = complex.generators.size();
  report.elements = given.complex.elements.size();
  report.stages = clock.finish();
  line.clear();
  std::cout << (options.json ? report_json(report) : report_text(report));
  return ExitStatus::verified;
}

}  // namespace

ExitStatus certify_complex(const CertifyCommand& options) {
  ProgressLine line;
  StageClock clock;
  const Progress progress = clock.callback(line.callback());
  clock.begin("read the complex");
  const std::string text = read_text(options.complex);
  const ComplexDescription complex = parse_complex(text, options.complex);
  if (complex.form.dimension() == 2) return certify<2>(options, complex, line, clock, progress);
  return certify<3>(options, complex, line, clock, progress);
}

}  // namespace delcert
