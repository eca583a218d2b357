#include "apps/space_form_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/distortion_report.hpp"
#include "apps/report_parts.hpp"
#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {

std::string triangulation_line(const Claims& claims, const Rational& unit) {
  if (!claims.triangulation->riemannian) return "triangulation: by geodesic simplices";
  return fmt::format(
      "triangulation: by geodesic simplices, and by Dyer, Vegter and Wintraecken: thickness ≥ {}, stars within {} ε",
      decimal_lower(claims.triangulation->riemannian->thickness),
      decimal_upper(claims.triangulation->riemannian->radius / unit));
}

/// What the theorem of Dyer, Vegter and Wintraecken asks of simplices, and what they are.
std::string riemannian_text(const RiemannianSimplices& simplices, const Rational& unit) {
  if (simplices.holds == Verdict::undecided) return "Riemannian   not every star could be measured\n";
  return fmt::format(
      "Riemannian   thickness ≥ {} in charts at the points, stars within {} ε; Dyer, Vegter and Wintraecken ask for {} "
      "ε\n",
      decimal_lower(Rational::exactly(simplices.thickness)),
      decimal_upper(Rational::exactly(simplices.star_radius) / unit),
      decimal_lower(Rational::exactly(simplices.scale) / unit));
}

nlohmann::ordered_json riemannian_json(const RiemannianSimplices& simplices) {
  if (simplices.holds == Verdict::undecided) return nullptr;
  return {{"thickness", exact_text(Rational::exactly(simplices.thickness))},
          {"star_radius", exact_text(Rational::exactly(simplices.star_radius))},
          {"most_star_radius", exact_text(Rational::exactly(simplices.scale))}};
}

std::vector<LevelLine> lines_of(const SpaceFormReport& report) {
  const Claims& claims = report.claims;
  const Rational& unit = report.sampling_radius;
  std::vector<LevelLine> lines;
  if (claims.input) {
    lines.push_back({"0", fmt::format("input: every point is within {} ε of the net",
                                      decimal_upper(claims.input->density->density / unit))});
  }
  if (claims.stars) lines.push_back({"1", stars_line(*claims.stars, unit)});
  if (claims.manifold) lines.push_back({"2", manifold_line(*claims.manifold)});
  if (claims.stable_stars)
    lines.push_back({"2s", "stable stars: every star is the same in the chart of each of its vertices"});
  if (claims.delaunay) {
    lines.push_back({"4", fmt::format("Delaunay in the manifold: protection ≥ {} ε, circumradius ≤ {} ε",
                                      decimal_lower(claims.delaunay->balls->protection / unit),
                                      decimal_upper(claims.delaunay->balls->circumradius / unit))});
  }
  if (claims.triangulation) lines.push_back({"5", triangulation_line(claims, unit)});
  if (claims.metric) {
    lines.push_back(
        {"6",
         fmt::format("metric: {}bi-Lipschitz with factors ≥ {}, ≤ {}", claims.metric->weight ? "self-Delaunay, " : "",
                     decimal_lower(claims.metric->least_stretch), decimal_upper(claims.metric->greatest_stretch))});
  }
  return lines;
}

}  // namespace

std::string report_text(const SpaceFormReport& report) {
  const PiecewiseFlatReport& flat = report.measures.flat;
  return title_text(report) +
         fmt::format("group        verified: curvature {}, injectivity radius ≥ {}, H₁ = {}\n",
                     sign_of(report.curvature), decimal_lower(report.injectivity_radius), report.first_homology) +
         fmt::format("net          {} points, ε = {}, μ₀ = {}, patches of radius {} ε\n", report.points,
                     exact_text(report.sampling_radius), exact_text(report.parameters.algorithm.separation),
                     report.patch_factor) +
         perturbation_text(report) + levels_text(report, lines_of(report)) + stability_text(report.measures.stability) +
         fmt::format("hinges       {} of {} not certainly locally Delaunay in the flat metric\n",
                     flat.not_delaunay + flat.undecided, flat.hinges) +
         riemannian_text(report.measures.simplices, report.sampling_radius) + distortion_text(report.distortion) +
         ending_text(report);
}

std::string report_json(const SpaceFormReport& report) {
  const PiecewiseFlatReport& flat = report.measures.flat;
  nlohmann::ordered_json json;
  json["manifold"] = report.manifold;
  json["curvature"] = sign_of(report.curvature);
  json["injectivity_radius"] = exact_text(report.injectivity_radius);
  json["first_homology_of_the_group"] = report.first_homology;
  json.update(parameters_json(report));
  json.update(levels_json(report, lines_of(report), report.claims.manifold, report.measures.stability));
  json["hinges"] = {{"all", flat.hinges}, {"not_locally_delaunay", flat.not_delaunay}, {"undecided", flat.undecided}};
  json["riemannian_simplices"] = riemannian_json(report.measures.simplices);
  json.update(distortion_json(report.distortion));
  json.update(ending_json(report));
  return json.dump(2) + "\n";
}

}  // namespace delcert
