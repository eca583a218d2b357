#include "apps/certify_metric_field_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/report_parts.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/document.hpp"

namespace delcert {

namespace {

std::string level_line(const MetricFieldReport& report, const std::string& level) {
  const MetricFieldClaims& claims = report.claims;
  const Rational& unit = report.sampling_radius;
  if (level == "1") {
    return fmt::format("stars, each in its chart: protection ≥ {} ε, thickness ≥ {}, circumradius ≤ {} ε",
                       decimal_lower(claims.stars->protection / unit), decimal_lower(claims.stars->thickness),
                       decimal_upper(claims.stars->circumradius / unit));
  }
  if (level == "2") {
    return fmt::format("manifold: {} simplices, Euler characteristic {}, homology {}", claims.manifold->simplices,
                       claims.manifold->euler_characteristic, fmt::join(homology_texts(*claims.manifold), ", "));
  }
  if (level == "2s") return "stable stars: every star is the same in the chart of each of its vertices";
  return fmt::format(
      "triangulation: by simplices that are straight in the torus, {} of them with agreeing lifts, one sheet",
      claims.manifold->simplices);
}

}  // namespace

std::string report_text(const MetricFieldReport& report) {
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  std::string out =
      fmt::format("{}, {} mode, seed {}\n\n", report.manifold, name_of(report.parameters.mode), algorithm.seed);
  out += fmt::format("metric       positive definite everywhere: eigenvalues ≥ {}, ≤ {}\n",
                     decimal_lower(report.eigenvalues.lower), decimal_upper(report.eigenvalues.upper));
  out += fmt::format("net          {} points, ε = {}, μ₀ = {}\n", report.points, exact_text(report.sampling_radius),
                     exact_text(algorithm.separation));
  out += fmt::format("charts       on patches of {} ε: ξ₀ ≤ {} of each other, κ ≤ {} of the metric, rounded by ≤ {}\n",
                     report.patch_factor, decimal_upper(report.distortion.transition),
                     decimal_upper(report.distortion.metric), decimal_upper(report.distortion.rounding));
  if (report.parameters.mode == RunMode::none) {
    out += "perturbation none\n";
  } else {
    out +=
        fmt::format("perturbation ρ₀ = {}, tolerances {} and {}, the best of {}\n", exact_text(algorithm.perturbation),
                    exact_text(algorithm.tolerance), exact_text(algorithm.clearance), algorithm.choices);
    out += "             " + tries_text(report.statistics) + "\n";
    out += fmt::format(
        "             at first {} stars not certified, {} not in agreement; {} repair rounds, {} points "
        "placed anew\n",
        report.first_failures, report.first_disagreeing, report.repair_rounds, report.repaired_points);
  }
  out += "levels\n";
  for (const std::string& level : report.claims.names())
    out += fmt::format("  {:<3} {}\n", level, level_line(report, level));
  for (const std::string& reason : report.reasons) out += "  not reached: " + reason + "\n";
  out += fmt::format("stars        {} of {} pairs of a star and a chart differ\n", report.measures.stability.differing,
                     report.measures.stability.pairs);
  out += stages_text(report.stages);
  out += fmt::format("peak memory  {:.0f} MiB\ncertificate  {}\n", report.peak_memory_mib, report.certificate);
  return out;
}

std::string report_json(const MetricFieldReport& report) {
  using Json = nlohmann::ordered_json;
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  Json json;
  json["manifold"] = report.manifold;
  json["eigenvalue_bounds"] = {exact_text(report.eigenvalues.lower), exact_text(report.eigenvalues.upper)};
  json["mode"] = name_of(report.parameters.mode);
  json["seed"] = algorithm.seed;
  json["points"] = report.points;
  json["simplices"] = report.simplices;
  json["sampling_radius"] = exact_text(report.sampling_radius);
  json["separation"] = exact_text(algorithm.separation);
  json["patch_factor"] = report.patch_factor;
  json["distortion"] = {{"transition", exact_text(report.distortion.transition)},
                        {"metric", exact_text(report.distortion.metric)},
                        {"rounding", exact_text(report.distortion.rounding)}};
  json["perturbation"] = exact_text(algorithm.perturbation);
  json["tolerance"] = exact_text(algorithm.tolerance);
  json["clearance"] = exact_text(algorithm.clearance);
  json["choices"] = algorithm.choices;
  json["statistics"] = {{"placements", report.statistics.placements},
                        {"tries", report.statistics.tries},
                        {"most_tries", report.statistics.most_tries},
                        {"candidates", report.statistics.candidates},
                        {"most_candidates", report.statistics.most_candidates},
                        {"visited", report.statistics.visited},
                        {"stars_not_certified_at_first", report.first_failures},
                        {"stars_not_in_agreement_at_first", report.first_disagreeing},
                        {"repair_rounds", report.repair_rounds},
                        {"repaired_points", report.repaired_points}};
  json["levels"] = report.claims.names();
  for (const std::string& level : report.claims.names()) json["margins"][level] = level_line(report, level);
  if (report.claims.manifold) {
    json["euler_characteristic"] = report.claims.manifold->euler_characteristic;
    json["homology"] = homology_texts(*report.claims.manifold);
  }
  json["not_reached"] = report.reasons;
  json["star_chart_pairs"] = {{"all", report.measures.stability.pairs},
                              {"differing", report.measures.stability.differing}};
  json["stages"] = stages_json(report.stages);
  json["peak_memory_mib"] = report.peak_memory_mib;
  json["certificate"] = report.certificate;
  return json.dump(2) + "\n";
}

}  // namespace delcert
