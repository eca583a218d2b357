#include "proofs/certification/level_line.hpp"

#include <fmt/format.h>

#include "proofs/certification/report_parts.hpp"

namespace delcert {

namespace {

/// A length in this unit.
std::string within(const Rational& length, const Rational& unit) { return decimal_upper(length / unit); }
std::string beyond(const Rational& length, const Rational& unit) { return decimal_lower(length / unit); }

std::string input_line(const InputClaim& input, const Rational& unit) {
  if (input.density)
    return fmt::format("input: every point is within {} ε of the net", within(input.density->density, unit));
  std::string out = "input: net, Hypotheses 1";
  if (!*input.hypotheses_2) return out;
  return out + (input.constraints == ParameterConstraints::printed ? ", Hypotheses 2" : ", the sharper Hypotheses 2");
}

std::string stars_line(const StarMargins& stars, const Rational& unit) {
  return fmt::format("stars: protection ≥ {} ε, thickness ≥ {}, circumradius ≤ {} ε", beyond(stars.protection, unit),
                     decimal_lower(stars.thickness), within(stars.circumradius, unit));
}

std::string manifold_line(const ManifoldClaim& manifold) {
  return fmt::format("manifold: {} simplices, Euler characteristic {}, homology {}{}", manifold.simplices,
                     manifold.euler_characteristic, fmt::join(homology_texts(manifold), ", "),
                     manifold.closed ? "; closed" : "; of the stars of interior labels");
}

std::string restricted_line(const DelaunayClaim::Restricted& restricted, const Rational& unit) {
  const auto& [extrinsic, intrinsic, density] = restricted;
  return fmt::format("Delaunay for {}; every point of the manifold is within {} ε of a vertex",
                     !intrinsic   ? "the distance in the space around it"
                     : !extrinsic ? "the length of curves"
                                  : "the distance in the space around it and for the length of curves",
                     within(density, unit));
}

std::string delaunay_line(const DelaunayClaim& delaunay, const Rational& unit) {
  if (delaunay.balls) {
    return fmt::format("Delaunay in the manifold: protection ≥ {} ε, circumradius ≤ {} ε",
                       beyond(delaunay.balls->protection, unit), within(delaunay.balls->circumradius, unit));
  }
  if (delaunay.stability) {
    return fmt::format("Delaunay for the distance of the metric: margin of stability ≥ {} ε²",
                       decimal_lower(delaunay.stability->margin / square(unit)));
  }
  if (delaunay.restricted) return restricted_line(*delaunay.restricted, unit);
  return "Delaunay: the complex is the Delaunay complex of the points in the manifold";
}

std::string triangulation_line(const Claims& claims, const Rational& unit) {
  const TriangulationClaim& triangulation = *claims.triangulation;
  if (triangulation.route == "affine-charts") {
    return fmt::format(
        "triangulation: by simplices that are straight in the torus, {} of them with agreeing lifts, one sheet",
        claims.manifold->simplices);
  }
  if (triangulation.graph) {
    // Between charts of an atlas blends need not be contractions: docs/levels/atlases.md.
    return fmt::format("triangulation: by straight simplices that are moved by ≤ {} ε, {} ≤ {}",
                       within(triangulation.graph->displacement, unit),
                       triangulation.route == "blended-charts" ? "volumes kept to (1 − γ)^m, γ" : "contraction",
                       decimal_upper(triangulation.graph->contraction));
  }
  if (triangulation.riemannian) {
    return fmt::format(
        "triangulation: by geodesic simplices, and by Dyer, Vegter and Wintraecken: thickness ≥ {}, stars within {} ε",
        decimal_lower(triangulation.riemannian->thickness), within(triangulation.riemannian->radius, unit));
  }
  return "triangulation: by geodesic simplices";
}

std::string isotopy_line(const IsotopyClaim& isotopy, const Rational& unit) {
  const char* says = "isotopy: the complex is embedded, ";
  if (isotopy.cosine)
    return fmt::format("{}cosine of the angle between its normals and gradients ≥ {}", says,
                       decimal_lower(*isotopy.cosine));
  return fmt::format("{}margin ≥ {} ε", says, beyond(*isotopy.margin, unit));
}

std::string metric_line(const MetricClaim& metric) {
  const std::string how = metric.self_delaunay ? "self-Delaunay, " : "";
  if (metric.least_stretch == Rational(1) && metric.greatest_stretch == Rational(1))
    return "metric: " + how + "isometric to the manifold";
  const std::string angles =
      metric.normal ? ", sine of the angle to tangent spaces ≤ " + decimal_upper(*metric.normal) : "";
  return fmt::format("metric: {}bi-Lipschitz with factors ≥ {}, ≤ {}{}", how, decimal_lower(metric.least_stretch),
                     decimal_upper(metric.greatest_stretch), angles);
}

}  // namespace

std::string level_line(const Claims& claims, const std::string& level, const Rational& unit) {
  if (level == "0") return input_line(*claims.input, unit);
  if (level == "1") return stars_line(*claims.stars, unit);
  if (level == "1f") return "full stars: every star is embedded in its chart, and full";
  if (level == "2") return manifold_line(*claims.manifold);
  if (level == "2s") return "stable stars: every star is the same in the chart of each of its vertices";
  if (level == "3") return "no forbidden configuration: " + *claims.no_forbidden;
  if (level == "4") return delaunay_line(*claims.delaunay, unit);
  if (level == "5") return triangulation_line(claims, unit);
  if (level == "5i") return isotopy_line(*claims.isotopy, unit);
  return metric_line(*claims.metric);
}

}  // namespace delcert
