#pragma once

#include <string>

#include "apps/chart_run_report.hpp"
#include "proofs/certificate/metric_field_claims.hpp"

namespace delcert {

/// What `delcert certify` says of a run on a metric field, for people and for programs.
struct MetricFieldReport : ChartRunReport {
  EigenvalueBounds eigenvalues;
  ChartDistortion distortion;
  MetricFieldMeasures measures;
  Claims claims;
};

/// A page of text. Decimal figures in it are rounded in the safe direction and marked by ≥ or ≤.
[[nodiscard]] std::string report_text(const MetricFieldReport& report);
/// The same as JSON; exact numbers are strings.
[[nodiscard]] std::string report_json(const MetricFieldReport& report);

}  // namespace delcert
