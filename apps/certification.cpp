#include "apps/certification.hpp"

#include <iostream>

#include "apps/kept_memory.hpp"
#include "apps/progress_line.hpp"
#include "proofs/certification/certification.hpp"
#include "proofs/certification/report_json.hpp"

namespace delcert {

ExitStatus certify(const CertifyCommand& command) {
  keep_freed_memory();
  ProgressLine line;
  RunReport report = certified_run(command, line.callback());
  line.clear();
  std::cout << (command.json ? report_json(report) : report_text(report));
  // The process is about to end, and its memory with it.
  static const auto* const left = new std::shared_ptr<const void>(std::move(report.made_from));
  (void)left;
  return ExitStatus::verified;
}

}  // namespace delcert
