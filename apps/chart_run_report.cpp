#include "apps/chart_run_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/report_parts.hpp"
#include "kernel/number/exact_text.hpp"

namespace delcert {

std::string title_text(const ChartRunReport& report) {
  return fmt::format("{}, {} mode, seed {}\n\n", report.manifold, name_of(report.parameters.mode),
                     report.parameters.algorithm.seed);
}

std::string perturbation_text(const ChartRunReport& report) {
  if (report.parameters.mode == RunMode::none) return "perturbation none\n";
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  return fmt::format(
      "perturbation ρ₀ = {}, tolerances {} and {}, the best of {}\n"
      "             {}\n"
      "             at first {} stars not certified, {} not in agreement; {} repair rounds, {} points placed anew\n",
      exact_text(algorithm.perturbation), exact_text(algorithm.tolerance), exact_text(algorithm.clearance),
      algorithm.choices, tries_text(report.statistics), report.first_failures, report.first_disagreeing,
      report.repair_rounds, report.repaired_points);
}

std::string levels_text(const ChartRunReport& report, const std::vector<LevelLine>& levels) {
  std::string out = "levels\n";
  for (const LevelLine& line : levels) out += fmt::format("  {:<3} {}\n", line.level, line.text);
  for (const std::string& reason : report.reasons) out += "  not reached: " + reason + "\n";
  return out;
}

std::string stability_text(const StarStability& stability) {
  return fmt::format("stars        {} of {} pairs of a star and a chart differ\n", stability.differing,
                     stability.pairs);
}

std::string ending_text(const ChartRunReport& report) {
  return stages_text(report.stages) +
         fmt::format("peak memory  {:.0f} MiB\ncertificate  {}\n", report.peak_memory_mib, report.certificate);
}

std::string stars_line(const StarMargins& margins, const Rational& sampling_radius) {
  return fmt::format("stars, each in its chart: protection ≥ {} ε, thickness ≥ {}, circumradius ≤ {} ε",
                     decimal_lower(margins.protection / sampling_radius), decimal_lower(margins.thickness),
                     decimal_upper(margins.circumradius / sampling_radius));
}

std::string manifold_line(const ManifoldClaim& manifold) {
  return fmt::format("manifold: {} simplices, Euler characteristic {}, homology {}", manifold.simplices,
                     manifold.euler_characteristic, fmt::join(homology_texts(manifold), ", "));
}

nlohmann::ordered_json parameters_json(const ChartRunReport& report) {
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  const PerturbationStatistics& statistics = report.statistics;
  nlohmann::ordered_json json;
  json["mode"] = name_of(report.parameters.mode);
  json["seed"] = algorithm.seed;
  json["points"] = report.points;
  json["simplices"] = report.simplices;
  json["sampling_radius"] = exact_text(report.sampling_radius);
  json["patch_factor"] = report.patch_factor;
  json["separation"] = exact_text(algorithm.separation);
  json["perturbation"] = exact_text(algorithm.perturbation);
  json["tolerance"] = exact_text(algorithm.tolerance);
  json["clearance"] = exact_text(algorithm.clearance);
  json["choices"] = algorithm.choices;
  json["statistics"] = {{"placements", statistics.placements},
                        {"tries", statistics.tries},
                        {"most_tries", statistics.most_tries},
                        {"candidates", statistics.candidates},
                        {"most_candidates", statistics.most_candidates},
                        {"visited", statistics.visited},
                        {"stars_not_certified_at_first", report.first_failures},
                        {"stars_not_in_agreement_at_first", report.first_disagreeing},
                        {"repair_rounds", report.repair_rounds},
                        {"repaired_points", report.repaired_points}};
  return json;
}

nlohmann::ordered_json levels_json(const ChartRunReport& report, const std::vector<LevelLine>& levels,
                                   const std::optional<ManifoldClaim>& manifold, const StarStability& stability) {
  nlohmann::ordered_json json;
  json["levels"] = nlohmann::ordered_json::array();
  for (const LevelLine& line : levels) json["levels"].push_back(line.level);
  for (const LevelLine& line : levels) json["margins"][line.level] = line.text;
  if (manifold) {
    json["euler_characteristic"] = manifold->euler_characteristic;
    json["homology"] = homology_texts(*manifold);
  }
  json["not_reached"] = report.reasons;
  json["star_chart_pairs"] = {
      {"all", stability.pairs}, {"differing", stability.differing}, {"stars_differing", stability.stars}};
  return json;
}

nlohmann::ordered_json ending_json(const ChartRunReport& report) {
  return {{"stages", stages_json(report.stages)},
          {"peak_memory_mib", report.peak_memory_mib},
          {"certificate", report.certificate}};
}

}  // namespace delcert
