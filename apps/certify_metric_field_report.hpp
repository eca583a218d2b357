#pragma once

#include <string>
#include <vector>

#include "apps/stage_clock.hpp"
#include "proofs/certificate/metric_field_claims.hpp"

namespace delcert {

/// What `delcert certify` says of a run on a metric field, for people and for programs.
struct MetricFieldReport {
  std::string manifold;
  EigenvalueBounds eigenvalues;
  ChartDistortion distortion;
  int patch_factor = 0;
  RunParameters parameters;
  Rational sampling_radius;
  std::size_t points = 0;
  std::size_t simplices = 0;
  PerturbationStatistics statistics;
  int repair_rounds = 0;
  std::size_t repaired_points = 0;
  std::size_t first_failures = 0;     ///< stars that were not certified before repair
  std::size_t first_disagreeing = 0;  ///< stars that did not agree with another then
  MetricFieldMeasures measures;
  MetricFieldClaims claims;
  std::vector<std::string> reasons;  ///< for levels that were asked for and not reached
  std::vector<StageClock::Stage> stages;
  double peak_memory_mib = 0;
  std::string certificate;  ///< the file
};

/// A page of text. Decimal figures in it are rounded in the safe direction and marked by ≥ or ≤.
[[nodiscard]] std::string report_text(const MetricFieldReport& report);
/// The same as JSON; exact numbers are strings.
[[nodiscard]] std::string report_json(const MetricFieldReport& report);

}  // namespace delcert
