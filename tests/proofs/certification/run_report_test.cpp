#include "proofs/certification/run_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "proofs/certification/report_json.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;

/// A run on a flat torus that claims level 1; of its family alone.
RunReport sample() {
  RunReport report;
  report.manifold = "torus";
  report.family = "flat-torus";
  report.dimension = Dimension(2);
  report.parameters.mode = RunMode::measured;
  report.parameters.algorithm.separation = Rational(1);
  report.sampling_radius = Rational(1) / Rational(10);
  report.points = 5;
  report.simplices = 10;
  report.claims.stars = StarMargins{Rational(1) / Rational(20), Rational(1) / Rational(3), Rational(1) / Rational(8)};
  return report;
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(RunReport, says_the_same_in_both_forms) {
  const RunReport report = sample();
  EXPECT_TRUE(mentions(report_text(report),
                       "  1   stars: protection ≥ 5.000e-01 ε, thickness ≥ 3.333e-01, circumradius ≤ 1.250e+00 ε\n"));
  const Json json = Json::parse(report_json(report));
  EXPECT_EQ(json["levels"].size(), 1U);
  const Json& margins = json["levels"]["1"];
  EXPECT_EQ(margins["protection"]["in_sampling_radii"], 0.5);
  EXPECT_EQ(margins["thickness"]["exact"], "1/3");
  EXPECT_EQ(margins["circumradius"]["value"], 0.125);
  EXPECT_EQ(json["points"], 5);
}

TEST(RunReport, leaves_out_what_the_family_does_not_have) {
  RunReport report = sample();
  for (const char* part : {"group ", "metric ", "patches", "charts ", "hinges", "stability", "at first"})
    EXPECT_FALSE(mentions(report_text(report), part)) << part;
  EXPECT_TRUE(Json::parse(report_json(report))["measures"].empty());
  EXPECT_FALSE(Json::parse(report_json(report))["manifold"].contains("curvature"));
  report.group = RunReport::Group{-1, Rational(3), "Z^4"};
  report.patch_factor = 9;
  report.stability.emplace().pairs = 4;
  EXPECT_TRUE(mentions(report_text(report), "curvature -1, injectivity radius ≥ 3.000e+00, H₁ = Z^4\n"));
  EXPECT_TRUE(mentions(report_text(report), ", patches of radius 9 ε\n"));
  EXPECT_TRUE(Json::parse(report_json(report))["parameters"]["patch_factor"].is_number_integer());
  report.patch_factor = Rational(19) / Rational(4);
  EXPECT_TRUE(mentions(report_text(report), ", patches of radius 19/4 ε\n"));
  EXPECT_EQ(Json::parse(report_json(report))["parameters"]["patch_factor"], 4.75);
  EXPECT_EQ(Json::parse(report_json(report))["manifold"]["curvature"], -1);
  EXPECT_EQ(Json::parse(report_json(report))["measures"]["star_chart_pairs"]["all"], 4);
}

TEST(RunReport, has_the_bounds_of_every_level_with_their_units) {
  RunReport report = sample();
  report.claims.manifold = ManifoldClaim{10, 0, true, {{1, {}}}};
  report.claims.delaunay = DelaunayClaim{{}, DelaunayClaim::Stability{Rational(1), Rational(1) / Rational(200)}};
  report.claims.metric = MetricClaim{true, {}};
  report.reasons = {"level 5: no"};
  const std::string text = report_text(report);
  EXPECT_TRUE(mentions(text, "margin of stability ≥ 5.000e-01 ε²\n")) << text;
  EXPECT_TRUE(mentions(text, "metric: self-Delaunay, isometric to the manifold\n")) << text;
  EXPECT_TRUE(mentions(text, "  not reached: level 5: no\n")) << text;
  const Json levels = Json::parse(report_json(report))["levels"];
  EXPECT_EQ(levels["2"], Json::parse(R"({"simplices":10,"euler_characteristic":0,"closed":true,"homology":["Z"]})"));
  EXPECT_EQ(levels["4"]["margin"]["unit"], "length^2");
  EXPECT_EQ(levels["4"]["margin"]["in_sampling_radii"], 0.5);
  EXPECT_EQ(levels["6"]["bilipschitz"][1]["bound"], "upper");
}

TEST(RunReport, of_an_atlas_says_what_was_verified) {
  RunReport report = sample();
  report.gluing = RunReport::Gluing{3, 4, {10, 20, 30}, Rational(1) / Rational(4)};
  const std::string text = report_text(report);
  EXPECT_TRUE(mentions(text,
                       "gluing       verified: 3 charts, 4 transitions; cocycles in 10 cells, limits in 20, cores in "
                       "30\n"))
      << text;
  EXPECT_TRUE(mentions(text, "charts       ξ₀ ≤ 2.500e-01 of each other\n")) << text;
  const Json json = Json::parse(report_json(report))["measures"]["gluing"];
  EXPECT_EQ(json["transitions"], 4);
  EXPECT_EQ(json["hausdorff_cells"], 20);
  EXPECT_EQ(json["distortion"]["bound"], "upper");
  EXPECT_FALSE(Json::parse(report_json(sample()))["measures"].contains("gluing"));
}

TEST(RunReport, of_a_submanifold_says_how_steep_charts_are_and_how_far_points_move) {
  RunReport report = sample();
  report.graphs = RunReport::Graphs{3, Rational(3) / Rational(4), Rational(1) / Rational(4), 17, -0.5, {}};
  report.claims.full_stars.emplace();
  report.claims.triangulation =
      TriangulationClaim{"graph", {}, TriangulationClaim::Graph{Rational(1) / Rational(8), Rational(1) / Rational(80)}};
  report.claims.isotopy = IsotopyClaim{Rational(1) / Rational(100)};
  const std::string text = report_text(report);
  EXPECT_TRUE(mentions(text,
                       "charts       slope ≤ 7.500e-01, ξ₀ ≤ 2.500e-01 of each other; all of the manifold, in 17 "
                       "parts of the box\n"))
      << text;
  EXPECT_TRUE(mentions(text, "  1f  full stars")) << text;
  EXPECT_TRUE(mentions(text,
                       "  5   triangulation: by straight simplices that are moved by ≤ 1.250e-01 ε, contraction ≤ "
                       "1.250e-01\n"))
      << text;
  RunReport of_atlas = report;
  of_atlas.claims.triangulation->route = "blended-charts";
  EXPECT_TRUE(mentions(report_text(of_atlas), "1.250e-01 ε, volumes kept to (1 − γ)^m, γ ≤ 1.250e-01\n"));
  EXPECT_FALSE(mentions(report_text(of_atlas), "contraction"));
  EXPECT_TRUE(mentions(text, "  5i  isotopy: the complex is embedded, margin ≥ 1.000e-01 ε\n")) << text;
  RunReport by_normals = report;
  by_normals.claims.isotopy = IsotopyClaim{{}, Rational(3) / Rational(4)};
  EXPECT_TRUE(
      mentions(report_text(by_normals),
               "  5i  isotopy: the complex is embedded, cosine of the angle between its normals and gradients ≥ "
               "7.500e-01\n"));
  const Json json = Json::parse(report_json(report));
  EXPECT_EQ(json["manifold"]["ambient_dimension"], 3);
  EXPECT_EQ(json["measures"]["graphs"]["isotopy_margin"]["value"], -0.5);
  EXPECT_EQ(json["measures"]["graphs"]["cover_parts"], 17);
  EXPECT_EQ(json["levels"]["5"]["displacement"]["in_sampling_radii"], 0.125);
  EXPECT_FALSE(mentions(text, "reach"));
  report.graphs->margin.reset();
  report.graphs->reach = ReachBound{2, 1.5, 0.5};
  const Json other = Json::parse(report_json(report));
  EXPECT_FALSE(other["measures"]["graphs"].contains("isotopy_margin"));
  EXPECT_EQ(other["measures"]["graphs"]["reach"]["least"]["value"], 0.5);
  EXPECT_TRUE(
      mentions(report_text(report), "reach        ≥ 5.000e-01: curvature ≤ 2.000e+00, bottlenecks ≥ 1.500e+00 long\n"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
