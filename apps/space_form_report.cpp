#include "apps/space_form_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/distortion_report.hpp"
#include "apps/report_parts.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/writer.hpp"

namespace delcert {

namespace {

std::string level_line(const SpaceFormReport& report, const std::string& level) {
  const SpaceFormClaims& claims = report.claims;
  const Rational& unit = report.sampling_radius;
  if (level == "0")
    return fmt::format("input: every point is within {} ε of the net", decimal_upper(*claims.density / unit));
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
  if (level == "4") {
    return fmt::format("Delaunay in the manifold: protection ≥ {} ε, circumradius ≤ {} ε",
                       decimal_lower(claims.delaunay->protection / unit),
                       decimal_upper(claims.delaunay->circumradius / unit));
  }
  if (level == "5") {
    if (!claims.riemannian) return "triangulation: by geodesic simplices";
    return fmt::format(
        "triangulation: by geodesic simplices, and by Dyer, Vegter and Wintraecken: thickness ≥ {}, "
        "stars within {} ε",
        decimal_lower(claims.riemannian->thickness), decimal_upper(claims.riemannian->radius / unit));
  }
  return fmt::format("metric: {}bi-Lipschitz with factors ≥ {}, ≤ {}", claims.metric->weight ? "self-Delaunay, " : "",
                     decimal_lower(claims.metric->least_stretch), decimal_upper(claims.metric->greatest_stretch));
}

}  // namespace

std::string report_text(const SpaceFormReport& report) {
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  std::string out =
      fmt::format("{}, {} mode, seed {}\n\n", report.manifold, name_of(report.parameters.mode), algorithm.seed);
  out += fmt::format("group        verified: curvature {}, injectivity radius ≥ {}, H₁ = {}\n",
                     sign_of(report.curvature), decimal_lower(report.injectivity_radius), report.first_homology);
  out += fmt::format("net          {} points, ε = {}, μ₀ = {}, patches of radius {} ε\n", report.points,
                     exact_text(report.sampling_radius), exact_text(algorithm.separation), report.patch_factor);
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
  for (const std::string& level : names_of(report.claims))
    out += fmt::format("  {:<3} {}\n", level, level_line(report, level));
  for (const std::string& reason : report.reasons) out += "  not reached: " + reason + "\n";
  out += fmt::format("stars        {} of {} pairs of a star and a chart differ\n", report.measures.stability.differing,
                     report.measures.stability.pairs);
  out += fmt::format("hinges       {} of {} not certainly locally Delaunay in the flat metric\n",
                     report.measures.flat.not_delaunay + report.measures.flat.undecided, report.measures.flat.hinges);
  out += distortion_text(report.distortion);
  out += stages_text(report.stages);
  out += fmt::format("peak memory  {:.0f} MiB\ncertificate  {}\n", report.peak_memory_mib, report.certificate);
  return out;
}

std::string report_json(const SpaceFormReport& report) {
  using Json = nlohmann::ordered_json;
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  Json json;
  json["manifold"] = report.manifold;
  json["curvature"] = sign_of(report.curvature);
  json["injectivity_radius"] = exact_text(report.injectivity_radius);
  json["first_homology_of_the_group"] = report.first_homology;
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
  json["levels"] = names_of(report.claims);
  for (const std::string& level : names_of(report.claims)) json["margins"][level] = level_line(report, level);
  if (report.claims.manifold) {
    json["euler_characteristic"] = report.claims.manifold->euler_characteristic;
    json["homology"] = homology_texts(*report.claims.manifold);
  }
  json["not_reached"] = report.reasons;
  json["star_chart_pairs"] = {{"all", report.measures.stability.pairs},
                              {"differing", report.measures.stability.differing}};
  json["hinges"] = {{"all", report.measures.flat.hinges},
                    {"not_locally_delaunay", report.measures.flat.not_delaunay},
                    {"undecided", report.measures.flat.undecided}};
  json.update(distortion_json(report.distortion));
  json["stages"] = stages_json(report.stages);
  json["peak_memory_mib"] = report.peak_memory_mib;
  json["certificate"] = report.certificate;
  return json.dump(2) + "\n";
}

}  // namespace delcert
