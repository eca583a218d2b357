#include "apps/run_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/report_parts.hpp"
#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {

std::string level_line(const RunReport& report, const std::string& level) {
  const Claims& claims = report.claims;
  const Rational& unit = report.sampling_radius;
  if (level == "0") {
    return fmt::format("input: net, Hypotheses 1{}", *claims.input->hypotheses_2 ? ", Hypotheses 2" : "");
  }
  if (level == "1") {
    return fmt::format("stars: protection ≥ {} ε, thickness ≥ {}, circumradius ≤ {} ε",
                       decimal_lower(claims.stars->protection / unit), decimal_lower(claims.stars->thickness),
                       decimal_upper(claims.stars->circumradius / unit));
  }
  if (level == "2") {
    return fmt::format("manifold: {} simplices, Euler characteristic {}, homology {}{}", claims.manifold->simplices,
                       claims.manifold->euler_characteristic, fmt::join(homology_texts(*claims.manifold), ", "),
                       claims.manifold->closed ? "; closed" : "; of the stars of interior labels");
  }
  if (level == "2s") return "stable stars: every star is the same in the chart of each of its vertices";
  if (level == "3") return "no forbidden configuration: " + claims.no_forbidden.value();
  if (level == "4") return "Delaunay: the complex is the Delaunay complex of the points in the manifold";
  if (level == "5") return "triangulation: it is homeomorphic to the manifold, by straight simplices";
  return "metric: isometric to the manifold, self-Delaunay";
}

}  // namespace

std::string report_text(const RunReport& report) {
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  std::string out = fmt::format("{}, {} mode, {} candidates, seed {}\n\n", report.manifold,
                                name_of(report.parameters.mode), name_of(algorithm.candidates), algorithm.seed);
  out += fmt::format("net          {} points, ε = {}, μ₀ = {}\n", report.points, exact_text(report.sampling_radius),
                     exact_text(algorithm.separation));
  for (const InputItem& item : report.input) {
    out += fmt::format("  {:<10} {} ({})\n", name_of(item.verdict), item.name, item.detail);
  }
  if (report.perturbed) {
    out += fmt::format("perturbation ρ₀ = {}, tolerance 2α̃₀ = {}, Γ₀² = {}\n", exact_text(algorithm.perturbation),
                       exact_text(algorithm.tolerance), exact_text(report.parameters.squared_flake_parameter));
    out += "             " + tries_text(report.statistics) + "\n";
    out += fmt::format("             {} repair rounds, {} points placed anew\n", report.repair_rounds,
                       report.repaired_points);
  } else {
    out += "perturbation none\n";
  }
  out += "levels\n";
  for (const std::string& level : report.claims.names()) {
    out += fmt::format("  {:<3} {}\n", level, level_line(report, level));
  }
  for (const std::string& reason : report.reasons) out += "  not reached: " + reason + "\n";
  out += stages_text(report.stages);
  out += fmt::format("peak memory  {:.0f} MiB\ncertificate  {}\n", report.peak_memory_mib, report.certificate);
  return out;
}

std::string report_json(const RunReport& report) {
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  nlohmann::ordered_json json;
  json["manifold"] = report.manifold;
  json["mode"] = name_of(report.parameters.mode);
  json["candidates"] = name_of(algorithm.candidates);
  json["seed"] = algorithm.seed;
  json["points"] = report.points;
  json["simplices"] = report.simplices;
  json["sampling_radius"] = exact_text(report.sampling_radius);
  json["separation"] = exact_text(algorithm.separation);
  json["perturbation"] = exact_text(algorithm.perturbation);
  json["tolerance"] = exact_text(algorithm.tolerance);
  json["flake_parameter_squared"] = exact_text(report.parameters.squared_flake_parameter);
  for (const InputItem& item : report.input) {
    json["input"].push_back({{"item", item.name}, {"verdict", name_of(item.verdict)}, {"values", item.detail}});
  }
  json["statistics"] = {{"placements", report.statistics.placements},
                        {"tries", report.statistics.tries},
                        {"most_tries", report.statistics.most_tries},
                        {"candidates", report.statistics.candidates},
                        {"most_candidates", report.statistics.most_candidates},
                        {"visited", report.statistics.visited},
                        {"repair_rounds", report.repair_rounds},
                        {"repaired_points", report.repaired_points}};
  json["levels"] = report.claims.names();
  if (report.claims.stars) {
    json["margins"] = {{"protection", exact_text(report.claims.stars->protection)},
                       {"thickness", exact_text(report.claims.stars->thickness)},
                       {"circumradius", exact_text(report.claims.stars->circumradius)}};
  }
  if (report.claims.manifold) {
    json["euler_characteristic"] = report.claims.manifold->euler_characteristic;
    json["homology"] = homology_texts(*report.claims.manifold);
  }
  json["not_reached"] = report.reasons;
  json["stages"] = stages_json(report.stages);
  json["peak_memory_mib"] = report.peak_memory_mib;
  json["certificate"] = report.certificate;
  return json.dump(2) + "\n";
}

}  // namespace delcert
