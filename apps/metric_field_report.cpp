#include "apps/metric_field_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/report_parts.hpp"
#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {

// A square of a length in units of ε².
std::string lower(const Rational& x, const MetricFieldReport& report) {
  return decimal_lower(x / square(report.sampling_radius));
}
std::string upper(const Rational& x, const MetricFieldReport& report) {
  return decimal_upper(x / square(report.sampling_radius));
}

std::string margin_text(const MetricFieldReport& report) {
  const std::optional<DelaunayMargin>& margin = report.claims.delaunay_margin;
  if (!margin) return "";
  return fmt::format("stability    the metric changes powers of points by ≤ {} ε², {} ε² are allowed: margin ≥ {} ε²\n",
                     upper(margin->change, report), lower(margin->allowed, report), lower(margin->value(), report));
}

std::vector<LevelLine> lines_of(const MetricFieldReport& report) {
  const Claims& claims = report.claims;
  std::vector<LevelLine> lines;
  if (claims.stars) lines.push_back({"1", stars_line(*claims.stars, report.sampling_radius)});
  if (claims.manifold) lines.push_back({"2", manifold_line(*claims.manifold)});
  if (claims.stable_stars)
    lines.push_back({"2s", "stable stars: every star is the same in the chart of each of its vertices"});
  if (claims.delaunay) {
    lines.push_back({"4", fmt::format("Delaunay for the distance of the metric: margin of stability ≥ {} ε²",
                                      lower(claims.delaunay->stability->margin, report))});
  }
  if (claims.triangulation) {
    lines.push_back({"5", fmt::format("triangulation: by simplices that are straight in the torus, {} of them with "
                                      "agreeing lifts, one sheet",
                                      claims.manifold->simplices)});
  }
  return lines;
}

}  // namespace

std::string report_text(const MetricFieldReport& report) {
  return title_text(report) +
         fmt::format("metric       positive definite everywhere: eigenvalues ≥ {}, ≤ {}\n",
                     decimal_lower(report.eigenvalues.lower), decimal_upper(report.eigenvalues.upper)) +
         fmt::format("net          {} points, ε = {}, μ₀ = {}\n", report.points, exact_text(report.sampling_radius),
                     exact_text(report.parameters.algorithm.separation)) +
         fmt::format("charts       on patches of {} ε: ξ₀ ≤ {} of each other, κ ≤ {} of the metric, rounded by ≤ {}\n",
                     report.patch_factor, decimal_upper(report.distortion.transition),
                     decimal_upper(report.distortion.metric), decimal_upper(report.distortion.rounding)) +
         perturbation_text(report) + levels_text(report, lines_of(report)) + margin_text(report) +
         stability_text(report.measures.stability) + ending_text(report);
}

std::string report_json(const MetricFieldReport& report) {
  nlohmann::ordered_json json;
  json["manifold"] = report.manifold;
  json["eigenvalue_bounds"] = {exact_text(report.eigenvalues.lower), exact_text(report.eigenvalues.upper)};
  json["distortion"] = {{"transition", exact_text(report.distortion.transition)},
                        {"metric", exact_text(report.distortion.metric)},
                        {"rounding", exact_text(report.distortion.rounding)}};
  json.update(parameters_json(report));
  json.update(levels_json(report, lines_of(report), report.claims.manifold, report.measures.stability));
  if (const auto& margin = report.claims.delaunay_margin) {
    json["delaunay_margin"] = {{"edge", exact_text(margin->edge)},
                               {"change", exact_text(margin->change)},
                               {"allowed", exact_text(margin->allowed)},
                               {"margin", exact_text(margin->value())},
                               {"is_enough", report.claims.delaunay.has_value()}};
  }
  json.update(ending_json(report));
  return json.dump(2) + "\n";
}

}  // namespace delcert
