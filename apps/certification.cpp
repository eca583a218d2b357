#include "apps/certification.hpp"

#include <iostream>

#include "apps/progress_line.hpp"
#include "proofs/certification/certification.hpp"
#include "proofs/certification/report_json.hpp"

namespace delcert {

ExitStatus certify(const CertifyCommand& command) {
  ProgressLine line;
  const RunReport report = certified_run(command, line.callback());
  line.clear();
  std::cout << (command.json ? report_json(report) : report_text(report));
  return ExitStatus::verified;
}

}  // namespace delcert
