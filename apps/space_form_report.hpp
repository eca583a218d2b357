#pragma once

#include <string>
#include <vector>

#include "apps/stage_clock.hpp"
#include "proofs/certificate/space_form_claims.hpp"
#include "proofs/certificate/space_form_distortion.hpp"

namespace delcert {

/// What `delcert certify` says of a run on a space form, for people and for programs.
struct SpaceFormReport {
  std::string manifold;
  Curvature curvature = Curvature::zero;
  Rational injectivity_radius;  ///< a lower bound
  std::string first_homology;   ///< of the group
  RunParameters parameters;
  Rational sampling_radius;
  int patch_factor = 0;  ///< the radius of patches, in sampling radii
  std::size_t points = 0;
  std::size_t simplices = 0;
  PerturbationStatistics statistics;
  int repair_rounds = 0;
  std::size_t repaired_points = 0;
  std::size_t first_failures = 0;     ///< stars that were not certified before repair
  std::size_t first_disagreeing = 0;  ///< stars that did not agree with another then
  SpaceFormMeasures measures;
  SpaceFormClaims claims;
  SpaceFormDistortion distortion;
  std::vector<std::string> reasons;  ///< for levels that were asked for and not reached
  std::vector<StageClock::Stage> stages;
  double peak_memory_mib = 0;
  std::string certificate;  ///< the file
};

/// A page of text. Decimal figures in it are rounded in the safe direction and marked by ≥ or ≤.
[[nodiscard]] std::string report_text(const SpaceFormReport& report);
/// The same as JSON; exact numbers are strings.
[[nodiscard]] std::string report_json(const SpaceFormReport& report);

}  // namespace delcert
