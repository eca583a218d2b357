#pragma once

#include <string>

#include "apps/chart_run_report.hpp"
#include "proofs/certificate/space_form_claims.hpp"
#include "proofs/certificate/space_form_distortion.hpp"

namespace delcert {

/// What `delcert certify` says of a run on a space form, for people and for programs.
struct SpaceFormReport : ChartRunReport {
  Curvature curvature = Curvature::zero;
  Rational injectivity_radius;  ///< a lower bound
  std::string first_homology;   ///< of the group
  SpaceFormMeasures measures;
  Claims claims;
  SpaceFormDistortion distortion;
};

/// A page of text. Decimal figures in it are rounded in the safe direction and marked by ≥ or ≤.
[[nodiscard]] std::string report_text(const SpaceFormReport& report);
/// The same as JSON; exact numbers are strings.
[[nodiscard]] std::string report_json(const SpaceFormReport& report);

}  // namespace delcert
