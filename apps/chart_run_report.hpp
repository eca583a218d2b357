#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/stage_clock.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/run_parameters.hpp"

namespace delcert {

/// What is said alike of all runs on manifolds that are seen through charts.
struct ChartRunReport {
  std::string manifold;
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
  std::vector<std::string> reasons;   ///< for levels that were asked for and not reached
  std::vector<StageClock::Stage> stages;
  double peak_memory_mib = 0;
  std::string certificate;  ///< the file

  template <int m>
  void take(const ChartRun<m>& run) {
    simplices = run.complex.simplices().size();
    statistics = run.statistics;
    repair_rounds = run.repair_rounds;
    repaired_points = run.repaired_points;
    first_failures = run.first_failures;
    first_disagreeing = run.first_agreement.stars;
  }
};

/// A level that is reached, and what is reached there.
struct LevelLine {
  std::string level;
  std::string text;
};

// Pages of text, part by part; decimal figures are rounded in the safe direction and marked by ≥ or ≤.
[[nodiscard]] std::string title_text(const ChartRunReport& report);
[[nodiscard]] std::string perturbation_text(const ChartRunReport& report);
[[nodiscard]] std::string levels_text(const ChartRunReport& report, const std::vector<LevelLine>& levels);
[[nodiscard]] std::string stability_text(const StarStability& stability);
[[nodiscard]] std::string ending_text(const ChartRunReport& report);

// What is said of levels 1 and 2.
[[nodiscard]] std::string stars_line(const StarMargins& margins, const Rational& sampling_radius);
[[nodiscard]] std::string manifold_line(const ManifoldClaim& manifold);

// The same as JSON; exact numbers are strings.
[[nodiscard]] nlohmann::ordered_json parameters_json(const ChartRunReport& report);
[[nodiscard]] nlohmann::ordered_json levels_json(const ChartRunReport& report, const std::vector<LevelLine>& levels,
                                                 const std::optional<ManifoldClaim>& manifold,
                                                 const StarStability& stability);
[[nodiscard]] nlohmann::ordered_json ending_json(const ChartRunReport& report);

}  // namespace delcert
