#include "proofs/certification/report_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"
#include "proofs/certification/distortion_report.hpp"
#include "proofs/certification/report_parts.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

Rational exactly(double x) { return Rational::exactly(x); }

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

/// A whole number, or a decimal: quarters are exact.
Json patch_json(const Rational& factor) {
  if (factor.denominator() == 1) return static_cast<std::int64_t>(approximate_double(factor));
  return approximate_double(factor);
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
  if (report.patch_factor) json["patch_factor"] = patch_json(*report.patch_factor);
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

Json metric_json(const ChartDistortion& charts) {
  return {{"transition", upper_json(charts.transition)},
          {"metric", upper_json(charts.metric)},
          {"rounding", upper_json(charts.rounding)}};
}

Json gluing_json(const RunReport::Gluing& gluing) {
  const GluingReport& cells = gluing.cells;
  return {{"charts", gluing.charts},
          {"transitions", gluing.transitions},
          {"cocycle_cells", cells.cocycle_cells},
          {"hausdorff_cells", cells.hausdorff_cells},
          {"compact_cells", cells.compact_cells},
          {"distortion", upper_json(gluing.distortion)}};
}

Json radii_json(const RunReport::Radii& radii, const Rational& unit) {
  return {{"least", lower_json(radii.least, Margin::Unit::length, unit)},
          {"variation", upper_json(radii.variation)},
          {"points_with_the_least", std::llround(radii.points_uniformly)}};
}

Json graphs_json(const RunReport::Graphs& graphs, const Rational& unit) {
  Json json{{"slope", upper_json(graphs.slope)},
            {"distortion", upper_json(graphs.distortion)},
            {"cover_parts", graphs.cover_parts}};
  if (const auto& reach = graphs.reach; reach && reach->reach > 0) {
    json["reach"] = {{"least", lower_json(exactly(reach->reach), Margin::Unit::length, unit)},
                     {"curvature", upper_json(exactly(reach->curvature))},
                     {"bottleneck", lower_json(exactly(reach->bottleneck), Margin::Unit::length, unit)}};
  }
  if (graphs.margin) json["isotopy_margin"] = lower_json(exactly(*graphs.margin), Margin::Unit::length, unit);
  return json;
}

Json delaunay_margin_json(const DelaunayMargin& margin, bool is_enough, const Rational& unit) {
  constexpr auto squared = Margin::Unit::squared_length;
  return {{"edge", lower_json(margin.edge, Margin::Unit::length, unit)},
          {"change", upper_json(margin.change, squared, unit)},
          {"allowed", lower_json(margin.allowed, squared, unit)},
          {"margin", lower_json(margin.value(), squared, unit)},
          {"is_enough", is_enough}};
}

Json riemannian_json(const RiemannianSimplices& simplices, const Rational& unit) {
  return {{"thickness", lower_json(exactly(simplices.thickness))},
          {"star_radius", upper_json(exactly(simplices.star_radius), Margin::Unit::length, unit)},
          {"most_star_radius", lower_json(exactly(simplices.scale), Margin::Unit::length, unit)}};
}

Json measures_json(const RunReport& report) {
  const Rational& unit = report.sampling_radius;
  Json json = Json::object();
  if (report.metric) json["charts"] = metric_json(report.metric->distortion);
  if (report.gluing) json["gluing"] = gluing_json(*report.gluing);
  if (report.radii) json["radii"] = radii_json(*report.radii, unit);
  if (report.graphs) json["graphs"] = graphs_json(*report.graphs, unit);
  if (const auto& margin = report.claims.delaunay_margin)
    json["delaunay_margin"] = delaunay_margin_json(*margin, report.claims.delaunay.has_value(), unit);
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
  if (report.riemannian && report.riemannian->holds != Verdict::undecided)
    json["riemannian_simplices"] = riemannian_json(*report.riemannian, unit);
  if (report.distortion) json.update(distortion_json(*report.distortion));
  return json;
}

}  // namespace

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
