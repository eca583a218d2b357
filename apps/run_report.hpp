#pragma once

#include <string>
#include <vector>

#include "apps/stage_clock.hpp"
#include "kernel/manifold/input_check.hpp"
#include "kernel/perturb/perturbation.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/run_parameters.hpp"

namespace delcert {

/// What `delcert certify` says of a run, for people and for programs.
struct RunReport {
  std::string manifold;
  RunParameters parameters;
  Rational sampling_radius;
  std::size_t points = 0;
  std::size_t simplices = 0;
  std::vector<InputItem> input;
  bool perturbed = true;
  PerturbationStatistics statistics;
  int repair_rounds = 0;
  std::size_t repaired_points = 0;
  Claims claims;
  std::vector<std::string> reasons;  ///< for levels that were asked for and not reached
  std::vector<StageClock::Stage> stages;
  double peak_memory_mib = 0;
  std::string certificate;  ///< the file
};

/// A page of text. Decimal figures in it are rounded in the safe direction and marked by ≥ or ≤.
[[nodiscard]] std::string report_text(const RunReport& report);
/// The same as JSON; exact numbers are strings.
[[nodiscard]] std::string report_json(const RunReport& report);

}  // namespace delcert
