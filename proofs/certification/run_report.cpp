#include "proofs/certification/run_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"
#include "proofs/certification/distortion_report.hpp"
#include "proofs/certification/report_parts.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

std::string head_text(const RunReport& report) {
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  std::string out = fmt::format("{}, {} mode, {} candidates, seed {}\n\n", report.manifold,
                                name_of(report.parameters.mode), name_of(algorithm.candidates), algorithm.seed);
  if (report.group) {
    out +=
        fmt::format("group        verified: curvature {}, injectivity radius ≥ {}, H₁ = {}\n", report.group->curvature,
                    decimal_lower(report.group->injectivity_radius), report.group->first_homology);
  }
  if (report.metric) {
    out +=
        fmt::format("metric       positive definite everywhere: eigenvalues ≥ {}, ≤ {}\n",
                    decimal_lower(report.metric->eigenvalues.lower), decimal_upper(report.metric->eigenvalues.upper));
  }
  if (report.gluing) {
    const auto& [charts, transitions, cells, distortion] = *report.gluing;
    out += fmt::format(
        "gluing       verified: {} charts, {} transitions; cocycles in {} cells, limits in {}, cores in {}\n", charts,
        transitions, cells.cocycle_cells, cells.hausdorff_cells, cells.compact_cells);
  }
  out += fmt::format("net          {} points, ε = {}, μ₀ = {}", report.points, exact_text(report.sampling_radius),
                     exact_text(algorithm.separation));
  out += report.patch_factor ? fmt::format(", patches of radius {} ε\n", *report.patch_factor) : "\n";
  for (const InputItem& item : report.input)
    out += fmt::format("  {:<10} {} ({})\n", name_of(item.verdict), item.name, item.detail);
  if (report.metric) {
    const ChartDistortion& charts = report.metric->distortion;
    out += fmt::format("charts       ξ₀ ≤ {} of each other, κ ≤ {} of the metric, rounded by ≤ {}\n",
                       decimal_upper(charts.transition), decimal_upper(charts.metric), decimal_upper(charts.rounding));
  }
  if (report.gluing)
    out += fmt::format("charts       ξ₀ ≤ {} of each other\n", decimal_upper(report.gluing->distortion));
  if (report.graphs) {
    out += fmt::format("charts       slope ≤ {}, ξ₀ ≤ {} of each other; all of the manifold, in {} parts of the box\n",
                       decimal_upper(report.graphs->slope), decimal_upper(report.graphs->distortion),
                       report.graphs->cover_parts);
  }
  if (report.graphs && report.graphs->reach && report.graphs->reach->reach > 0) {
    out += fmt::format("reach        ≥ {}: curvature ≤ {}, bottlenecks ≥ {} long\n",
                       decimal_lower(Rational::exactly(report.graphs->reach->reach)),
                       decimal_upper(Rational::exactly(report.graphs->reach->curvature)),
                       decimal_lower(Rational::exactly(report.graphs->reach->bottleneck)));
  }
  if (report.radii) {
    out += fmt::format(
        "radii        {} to {}, ε₀ ≤ {} within {}; with the least everywhere there would be about {:.0f} points\n",
        decimal_lower(report.radii->least), decimal_upper(report.sampling_radius),
        decimal_upper(report.radii->variation), report.radii->reach, report.radii->points_uniformly);
  }
  return out;
}

std::string perturbation_text(const RunReport& report) {
  if (report.parameters.mode == RunMode::none) return "perturbation none\n";
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  std::string out = fmt::format("perturbation ρ₀ = {}, tolerance {}", exact_text(algorithm.perturbation),
                                exact_text(algorithm.tolerance));
  if (report.parameters.mode == RunMode::theory)
    out += " = 2α̃₀, Γ₀² = " + exact_text(report.parameters.squared_flake_parameter);
  out += "\n";
  if (algorithm.clearance > Rational(0)) {
    out += fmt::format("             second tolerance {}, the best of {}\n", exact_text(algorithm.clearance),
                       algorithm.choices);
  }
  out += "             " + tries_text(report.statistics) + "\n             ";
  if (report.first) {
    out += fmt::format("at first {} stars not certified, {} not in agreement; ", report.first->failures,
                       report.first->disagreeing);
  }
  out += fmt::format("{} repair rounds, {} points placed anew\n", report.repair_rounds, report.repaired_points);
  if (report.refinement_rounds > 0)
    out += fmt::format("             {} round{} of refinement\n", report.refinement_rounds,
                       report.refinement_rounds == 1 ? "" : "s");
  return out;
}

/// What was measured beyond the levels.
std::string measures_text(const RunReport& report) {
  const Rational& unit = report.sampling_radius;
  std::string out;
  if (const auto& margin = report.claims.delaunay_margin) {
    const Rational squared = square(unit);
    out +=
        fmt::format("stability    the metric changes powers of points by ≤ {} ε², {} ε² are allowed: margin ≥ {} ε²\n",
                    decimal_upper(margin->change / squared), decimal_lower(margin->allowed / squared),
                    decimal_lower(margin->value() / squared));
  }
  if (report.stability) {
    out += fmt::format("stars        {} of {} pairs of a star and a chart differ\n", report.stability->differing,
                       report.stability->pairs);
  }
  if (report.flat) {
    out += fmt::format("hinges       {} of {} not certainly locally Delaunay in the flat metric\n",
                       report.flat->not_delaunay + report.flat->undecided, report.flat->hinges);
  }
  if (report.riemannian && report.riemannian->holds == Verdict::undecided) {
    out += "Riemannian   not every star could be measured\n";
  } else if (report.riemannian) {
    out += fmt::format(
        "Riemannian   thickness ≥ {} in charts at the points, stars within {} ε; Dyer, Vegter and Wintraecken ask for "
        "{} ε\n",
        decimal_lower(Rational::exactly(report.riemannian->thickness)),
        decimal_upper(Rational::exactly(report.riemannian->star_radius) / unit),
        decimal_lower(Rational::exactly(report.riemannian->scale) / unit));
  }
  return report.distortion ? out + distortion_text(*report.distortion) : out;
}

Json manifold_json(const RunReport& report) {
  const Rational& unit = report.sampling_radius;
  Json json{{"name", report.manifold}, {"family", report.family}, {"dimension", report.dimension.value}};
  if (report.group) {
    json["curvature"] = report.group->curvature;
    json["injectivity_radius"] = lower_json(report.group->injectivity_radius, Margin::Unit::length, unit);
    json["first_homology_of_the_group"] = report.group->first_homology;
  }
  if (report.metric) {
    json["eigenvalues"] = {lower_json(report.metric->eigenvalues.lower), upper_json(report.metric->eigenvalues.upper)};
  }
  if (report.graphs) json["ambient_dimension"] = report.graphs->ambient_dimension;
  return json;
}

Json parameters_json(const RunReport& report) {
  const PerturbationParameters& algorithm = report.parameters.algorithm;
  Json json{{"mode", name_of(report.parameters.mode)},
            {"candidates", name_of(algorithm.candidates)},
            {"seed", algorithm.seed},
            {"sampling_radius", exact_text(report.sampling_radius)},
            {"separation", exact_text(algorithm.separation)},
            {"perturbation", exact_text(algorithm.perturbation)},
            {"tolerance", exact_text(algorithm.tolerance)},
            {"clearance", exact_text(algorithm.clearance)},
            {"choices", algorithm.choices},
            {"flake_parameter_squared", exact_text(report.parameters.squared_flake_parameter)}};
  if (report.patch_factor) json["patch_factor"] = *report.patch_factor;
  return json;
}

Json statistics_json(const RunReport& report) {
  const PerturbationStatistics& statistics = report.statistics;
  Json json{{"placements", statistics.placements},           {"tries", statistics.tries},
            {"most_tries", statistics.most_tries},           {"candidates", statistics.candidates},
            {"most_candidates", statistics.most_candidates}, {"visited", statistics.visited}};
  if (report.first) {
    json["stars_not_certified_at_first"] = report.first->failures;
    json["stars_not_in_agreement_at_first"] = report.first->disagreeing;
  }
  json["repair_rounds"] = report.repair_rounds;
  json["repaired_points"] = report.repaired_points;
  if (report.refinement_rounds > 0) json["refinement_rounds"] = report.refinement_rounds;
  return json;
}

Json measures_json(const RunReport& report) {
  const Rational& unit = report.sampling_radius;
  const auto exactly = [](double x) { return Rational::exactly(x); };
  Json json = Json::object();
  if (report.metric) {
    const ChartDistortion& charts = report.metric->distortion;
    json["charts"] = {{"transition", upper_json(charts.transition)},
                      {"metric", upper_json(charts.metric)},
                      {"rounding", upper_json(charts.rounding)}};
  }
  if (report.gluing) {
    const GluingReport& cells = report.gluing->cells;
    json["gluing"] = {{"charts", report.gluing->charts},      {"transitions", report.gluing->transitions},
                      {"cocycle_cells", cells.cocycle_cells}, {"hausdorff_cells", cells.hausdorff_cells},
                      {"compact_cells", cells.compact_cells}, {"distortion", upper_json(report.gluing->distortion)}};
  }
  if (report.radii) {
    json["radii"] = {{"least", lower_json(report.radii->least, Margin::Unit::length, unit)},
                     {"variation", upper_json(report.radii->variation)},
                     {"points_with_the_least", std::llround(report.radii->points_uniformly)}};
  }
  if (report.graphs) {
    json["graphs"] = {{"slope", upper_json(report.graphs->slope)},
                      {"distortion", upper_json(report.graphs->distortion)},
                      {"cover_parts", report.graphs->cover_parts}};
    if (const auto& reach = report.graphs->reach; reach && reach->reach > 0) {
      json["graphs"]["reach"] = {
          {"least", lower_json(Rational::exactly(reach->reach), Margin::Unit::length, unit)},
          {"curvature", upper_json(Rational::exactly(reach->curvature))},
          {"bottleneck", lower_json(Rational::exactly(reach->bottleneck), Margin::Unit::length, unit)}};
    }
    if (report.graphs->margin)
      json["graphs"]["isotopy_margin"] = lower_json(exactly(*report.graphs->margin), Margin::Unit::length, unit);
  }
  if (const auto& margin = report.claims.delaunay_margin) {
    constexpr auto squared = Margin::Unit::squared_length;
    json["delaunay_margin"] = {{"edge", lower_json(margin->edge, Margin::Unit::length, unit)},
                               {"change", upper_json(margin->change, squared, unit)},
                               {"allowed", lower_json(margin->allowed, squared, unit)},
                               {"margin", lower_json(margin->value(), squared, unit)},
                               {"is_enough", report.claims.delaunay.has_value()}};
  }
  if (report.stability) {
    json["star_chart_pairs"] = {{"all", report.stability->pairs},
                                {"differing", report.stability->differing},
                                {"stars_differing", report.stability->stars},
                                {"stars_with_occupied_balls", report.stability->occupied}};
  }
  if (report.flat) {
    json["hinges"] = {{"all", report.flat->hinges},
                      {"not_locally_delaunay", report.flat->not_delaunay},
                      {"undecided", report.flat->undecided}};
  }
  if (report.riemannian && report.riemannian->holds != Verdict::undecided) {
    json["riemannian_simplices"] = {
        {"thickness", lower_json(exactly(report.riemannian->thickness))},
        {"star_radius", upper_json(exactly(report.riemannian->star_radius), Margin::Unit::length, unit)},
        {"most_star_radius", lower_json(exactly(report.riemannian->scale), Margin::Unit::length, unit)}};
  }
  if (report.distortion) json.update(distortion_json(*report.distortion));
  return json;
}

}  // namespace

RunReport::Radii radii_report(const SamplingRadii& radii, const Rational& variation, Dimension dimension,
                              std::string reach) {
  const double least = radii.least_unit();
  RunReport::Radii result{radii.greatest() * Rational::exactly(least), variation, std::move(reach), 0};
  for (const double unit : radii.units()) {
    double share = 1;
    for (int k = 0; k < dimension.value; ++k) share *= unit / least;
    result.points_uniformly += share;
  }
  return result;
}

std::string level_line(const Claims& claims, const std::string& level, const Rational& unit) {
  const auto within = [&unit](const Rational& length) { return decimal_upper(length / unit); };
  const auto beyond = [&unit](const Rational& length) { return decimal_lower(length / unit); };
  if (level == "0" && claims.input->density)
    return fmt::format("input: every point is within {} ε of the net", within(claims.input->density->density));
  if (level == "0")
    return std::string("input: net, Hypotheses 1") + (!*claims.input->hypotheses_2 ? ""
                                                      : claims.input->constraints == ParameterConstraints::printed
                                                          ? ", Hypotheses 2"
                                                          : ", the sharper Hypotheses 2");
  if (level == "1") {
    return fmt::format("stars: protection ≥ {} ε, thickness ≥ {}, circumradius ≤ {} ε",
                       beyond(claims.stars->protection), decimal_lower(claims.stars->thickness),
                       within(claims.stars->circumradius));
  }
  if (level == "2") {
    return fmt::format("manifold: {} simplices, Euler characteristic {}, homology {}{}", claims.manifold->simplices,
                       claims.manifold->euler_characteristic, fmt::join(homology_texts(*claims.manifold), ", "),
                       claims.manifold->closed ? "; closed" : "; of the stars of interior labels");
  }
  if (level == "2s") return "stable stars: every star is the same in the chart of each of its vertices";
  if (level == "3") return "no forbidden configuration: " + *claims.no_forbidden;
  if (level == "4" && claims.delaunay->balls) {
    return fmt::format("Delaunay in the manifold: protection ≥ {} ε, circumradius ≤ {} ε",
                       beyond(claims.delaunay->balls->protection), within(claims.delaunay->balls->circumradius));
  }
  if (level == "4" && claims.delaunay->stability) {
    return fmt::format("Delaunay for the distance of the metric: margin of stability ≥ {} ε²",
                       decimal_lower(claims.delaunay->stability->margin / square(unit)));
  }
  if (level == "4" && claims.delaunay->restricted) {
    const auto& [extrinsic, intrinsic, density] = *claims.delaunay->restricted;
    return fmt::format("Delaunay for {}; every point of the manifold is within {} ε of a vertex",
                       !intrinsic   ? "the distance in the space around it"
                       : !extrinsic ? "the length of curves"
                                    : "the distance in the space around it and for the length of curves",
                       decimal_upper(density / unit));
  }
  if (level == "4") return "Delaunay: the complex is the Delaunay complex of the points in the manifold";
  if (level == "5" && claims.triangulation->route == "affine-charts") {
    return fmt::format(
        "triangulation: by simplices that are straight in the torus, {} of them with agreeing lifts, one "
        "sheet",
        claims.manifold->simplices);
  }
  if (level == "1f") return "full stars: every star is embedded in its chart, and full";
  if (level == "5" && claims.triangulation->graph) {
    // Between charts of an atlas blends need not be contractions: docs/levels/atlases.md.
    return fmt::format("triangulation: by straight simplices that are moved by ≤ {} ε, {} ≤ {}",
                       within(claims.triangulation->graph->displacement),
                       claims.triangulation->route == "blended-charts" ? "volumes kept to (1 − γ)^m, γ" : "contraction",
                       decimal_upper(claims.triangulation->graph->contraction));
  }
  if (level == "5i")
    return fmt::format("isotopy: the complex is embedded, margin ≥ {} ε", beyond(claims.isotopy->margin));
  if (level == "5" && claims.triangulation->riemannian) {
    return fmt::format(
        "triangulation: by geodesic simplices, and by Dyer, Vegter and Wintraecken: thickness ≥ {}, stars within {} ε",
        decimal_lower(claims.triangulation->riemannian->thickness), within(claims.triangulation->riemannian->radius));
  }
  if (level == "5") return "triangulation: by geodesic simplices";
  const MetricClaim& metric = *claims.metric;
  const std::string how = metric.self_delaunay ? "self-Delaunay, " : "";
  if (metric.least_stretch == Rational(1) && metric.greatest_stretch == Rational(1))
    return "metric: " + how + "isometric to the manifold";
  const std::string angles =
      metric.normal ? ", sine of the angle to tangent spaces ≤ " + decimal_upper(*metric.normal) : "";
  return fmt::format("metric: {}bi-Lipschitz with factors ≥ {}, ≤ {}{}", how, decimal_lower(metric.least_stretch),
                     decimal_upper(metric.greatest_stretch), angles);
}

nlohmann::ordered_json levels_json(const Claims& claims, const Rational& sampling_radius) {
  return levels_json(claimed_levels(claims), sampling_radius);
}
nlohmann::ordered_json levels_json(const std::vector<ClaimedLevel>& levels, const Rational& sampling_radius) {
  Json json = Json::object();
  for (const ClaimedLevel& level : levels) {
    Json& entries = json[level.name] = Json::object();
    for (const LevelEntry& entry : level.entries) {
      Json bounds = Json::array();
      for (const Margin& margin : entry.margins) bounds.push_back(bound_json(margin, sampling_radius));
      entries[entry.key] = bounds.empty() ? Json::parse(entry.json) : bounds.size() == 1 ? bounds[0] : bounds;
    }
  }
  return json;
}

std::string report_text(const RunReport& report) {
  std::string out = head_text(report) + perturbation_text(report) + "levels\n";
  for (const std::string& level : report.claims.names())
    out += fmt::format("  {:<3} {}\n", level, level_line(report.claims, level, report.sampling_radius));
  for (const std::string& reason : report.reasons) out += "  not reached: " + reason + "\n";
  return out + measures_text(report) + stages_text(report.stages) +
         fmt::format("peak memory  {:.0f} MiB\ncertificate  {}\n", report.peak_memory_mib, report.certificate);
}

std::string report_json(const RunReport& report) {
  Json input = Json::array();
  for (const InputItem& item : report.input)
    input.push_back({{"item", item.name}, {"verdict", name_of(item.verdict)}, {"values", item.detail}});
  const Json json{{"format", "delcert-report"},
                  {"version", 1},
                  {"manifold", manifold_json(report)},
                  {"parameters", parameters_json(report)},
                  {"points", report.points},
                  {"simplices", report.simplices},
                  {"input", input},
                  {"statistics", statistics_json(report)},
                  {"levels", levels_json(report.claims, report.sampling_radius)},
                  {"not_reached", report.reasons},
                  {"measures", measures_json(report)},
                  {"stages", stages_json(report.stages)},
                  {"peak_memory_mib", report.peak_memory_mib},
                  {"certificate", report.certificate}};
  return json.dump(2) + "\n";
}

}  // namespace delcert
