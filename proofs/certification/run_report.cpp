#include "proofs/certification/run_report.hpp"

#include <fmt/format.h>

#include "kernel/number/exact_text.hpp"
#include "proofs/certification/distortion_report.hpp"
#include "proofs/certification/level_line.hpp"
#include "proofs/certification/report_parts.hpp"

namespace delcert {

namespace {

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
  out += report.patch_factor ? fmt::format(", patches of radius {} ε\n", exact_text(*report.patch_factor)) : "\n";
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

std::string report_text(const RunReport& report) {
  std::string out = head_text(report) + perturbation_text(report) + "levels\n";
  for (const std::string& level : report.claims.names())
    out += fmt::format("  {:<3} {}\n", level, level_line(report.claims, level, report.sampling_radius));
  for (const std::string& reason : report.reasons) out += "  not reached: " + reason + "\n";
  return out + measures_text(report) + stages_text(report.stages) +
         fmt::format("peak memory  {:.0f} MiB\ncertificate  {}\n", report.peak_memory_mib, report.certificate);
}

}  // namespace delcert
