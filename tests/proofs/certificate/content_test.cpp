#include "proofs/certificate/content.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/reader.hpp"
#include "tests/proofs/certificate/atlas_run.hpp"
#include "tests/proofs/certificate/metric_field_run.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/proofs/certificate/submanifold_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(Content, GroupsAreWrittenExactly) {
  const SpaceForm form = verify_space_form(find_space_form("klein-quartic"));
  const Json json = Json::parse(manifold_object(form));
  EXPECT_EQ(keys_of(json), (std::vector<std::string>{"name", "family", "dimension", "field", "root", "time", "gram",
                                                     "generators", "injectivity_radius"}));
  EXPECT_EQ(json["family"], "hyperbolic");
  EXPECT_EQ(json["field"], Json::parse(R"(["1","-2","-1","1"])"));
  EXPECT_EQ(json["time"], Json::parse(R"(["136","-196","-244"])"));
  ASSERT_EQ(json["generators"].size(), form.description.generators.size());
  const FieldElement& entry = form.description.generators[3](2, 1);
  std::vector<Rational> read;
  for (const Json& coefficient : json["generators"][3][2][1])
    read.push_back(parse_exact(coefficient.get<std::string>()));
  EXPECT_EQ(read, entry.coefficients());
  // The only root of t^3 - t^2 - 2t + 1 above 1.
  const Rational lower = parse_exact(json["root"][0].get<std::string>()),
                 upper = parse_exact(json["root"][1].get<std::string>());
  const auto value = [](const Rational& t) { return ((t - Rational(1)) * t - Rational(2)) * t + Rational(1); };
  EXPECT_LT(value(lower), Rational(0));
  EXPECT_GT(value(upper), Rational(0));
  EXPECT_GT(lower, Rational(1));
}

TEST(Content, FamiliesAreNamedByTheirCurvature) {
  EXPECT_EQ(family_of(Curvature::positive), "spherical");
  EXPECT_EQ(family_of(Curvature::zero), "flat");
  EXPECT_EQ(family_of(Curvature::negative), "hyperbolic");
}

Rational exact(const Json& text) { return parse_exact(text.get<std::string>()); }

TEST(Content, OfAMetricFieldHasTheKeysOfTheFormatAndTheReaderReadsThem) {
  const auto& sample = test::sheared_run();
  const test::TemporaryFolder folder;
  std::vector<std::string> reasons;
  sample.write(folder / "m.json", sample.claims(reasons));
  const Json json = Json::parse(bytes_of(folder / "m.json"));
  EXPECT_EQ(keys_of(json), (std::vector<std::string>{"format", "version", "software", "manifold", "parameters",
                                                     "levels", "net", "charts", "net_simplices", "points", "elements",
                                                     "simplices", "loops", "sha256"}));
  EXPECT_EQ(keys_of(json["manifold"]), (std::vector<std::string>{"name", "family", "dimension", "constant", "waves",
                                                                 "rounding", "patch_radius", "metric_distortion"}));
  EXPECT_EQ(json["manifold"]["family"], "metric-field");
  EXPECT_EQ(json["manifold"]["constant"], Json::parse(R"([["1","0"],["0","2"]])"));
  EXPECT_EQ(json["manifold"]["waves"][0],
            Json::parse(R"({"frequency":[1,0],"cosine":[["0","0"],["0","0"]],"sine":[["0","1/10"],["1/10","1/10"]]})"));
  EXPECT_EQ(json["manifold"]["waves"][1]["frequency"], Json::parse("[1,-1]"));
  EXPECT_EQ(exact(json["manifold"]["patch_radius"]), sample.atlas.patch_radius());
  EXPECT_EQ(exact(json["parameters"]["distortion"]), sample.distortion.transition);
  EXPECT_EQ(keys_of(json["levels"]), (std::vector<std::string>{"1", "2", "2s", "5"}));
  EXPECT_EQ(json["levels"]["5"], Json::parse(R"({"route":"affine-charts"})"));
  ASSERT_EQ(json["charts"].size(), sample.atlas.size());
  ASSERT_EQ(json["charts"][3].size(), 3U);
  const auto& matrix = sample.atlas.chart(Label(3)).matrix();
  EXPECT_EQ(exact(json["charts"][3][0]), matrix[0][0]);
  EXPECT_EQ(exact(json["charts"][3][1]), matrix[0][1]);
  EXPECT_EQ(exact(json["charts"][3][2]), matrix[1][1]);
  EXPECT_EQ(exact(json["net"][3][1]), sample.atlas.centre(Label(3))[1]);
  EXPECT_EQ(exact(json["points"][3][1]), sample.run.points.exact(Label(3))[1]);

  const CertificateSummary read = read_certificate(folder / "m.json");
  EXPECT_EQ(read.family, "metric-field");
  EXPECT_EQ(read.manifold.name, "shear");
  EXPECT_EQ(read.simplices.size(), sample.run.complex.simplices().size());
  EXPECT_EQ(read.levels.size(), 4U);
}

TEST(Content, OfAMetricFieldHasTheMarginsOfLevel4) {
  const auto& sample = test::flat_run();
  const test::TemporaryFolder folder;
  std::vector<std::string> reasons;
  const auto claims = sample.claims(reasons);
  sample.write(folder / "m.json", claims);
  const Json json = Json::parse(bytes_of(folder / "m.json"));
  EXPECT_EQ(keys_of(json["levels"]), (std::vector<std::string>{"1", "2", "2s", "4", "5"}));
  EXPECT_EQ(keys_of(json["levels"]["4"]), (std::vector<std::string>{"edge", "margin"}));
  EXPECT_EQ(exact(json["levels"]["4"]["edge"]), claims.delaunay->stability->edge);
  EXPECT_EQ(exact(json["levels"]["4"]["margin"]), claims.delaunay->stability->margin);
  EXPECT_EQ(read_certificate(folder / "m.json").levels.size(), 5U);
}

TEST(Content, OfAnAtlasHasItsChartsAndTransitions) {
  const auto& sample = test::glued_sphere_run();
  const test::TemporaryFolder folder;
  std::vector<std::string> reasons;
  sample.write(folder / "a.json", sample.claims(reasons, {"1", "2"}));
  const Json json = Json::parse(bytes_of(folder / "a.json"));
  EXPECT_EQ(keys_of(json["manifold"]),
            (std::vector<std::string>{"name", "family", "dimension", "charts", "transitions", "patch_radius"}));
  EXPECT_EQ(json["manifold"]["family"], "atlas");
  EXPECT_EQ(json["manifold"]["charts"][1],
            Json::parse(R"({"name":"south","variables":["u","v"],"domain":[["-2","2"],["-2","2"]],)"
                        R"("core":[["-3/2","3/2"],["-3/2","3/2"]]})"));
  ASSERT_EQ(json["manifold"]["transitions"].size(), 1U);
  EXPECT_EQ(keys_of(json["manifold"]["transitions"][0]),
            (std::vector<std::string>{"from", "to", "map", "inverse", "where"}));
  EXPECT_EQ(json["manifold"]["transitions"][0]["to"], 1);
  EXPECT_EQ(json["manifold"]["transitions"][0]["map"][1], "y/(x^2+y^2)");
  EXPECT_EQ(exact(json["manifold"]["patch_radius"]), sample.atlas.patch_radius());
  EXPECT_EQ(exact(json["parameters"]["distortion"]), sample.distortion);
  ASSERT_EQ(json["charts"].size(), sample.atlas.size());
  for (const std::uint32_t index : {0U, 7U, 300U}) {
    const Label i(index);
    ASSERT_EQ(json["charts"][index].size(), 4U);
    EXPECT_EQ(exact(json["charts"][index][0]), Rational(Integer(sample.atlas.home_chart(i))));
    EXPECT_EQ(exact(json["charts"][index][2]), sample.atlas.chart(i).matrix()[0][1]);
    EXPECT_EQ(exact(json["charts"][index][3]), sample.atlas.chart(i).matrix()[1][1]);
    EXPECT_EQ(exact(json["net"][index][1]), sample.atlas.centre(i)[1]);
    EXPECT_EQ(exact(json["points"][index][0]), sample.run.points.exact(i)[0]);
  }
  const CertificateSummary read = read_certificate(folder / "a.json");
  EXPECT_EQ(read.family, "atlas");
  EXPECT_EQ(read.simplices.size(), sample.run.complex.simplices().size());
}

TEST(Content, OfASubmanifoldHasItsEquationsAndCharts) {
  const auto& sample = test::sphere_run();
  const test::TemporaryFolder folder;
  std::vector<std::string> reasons;
  sample.write(folder / "s.json", sample.claims(reasons));
  const Json json = Json::parse(bytes_of(folder / "s.json"));
  EXPECT_EQ(keys_of(json["manifold"]), (std::vector<std::string>{"name", "family", "dimension", "variables",
                                                                 "equations", "box", "slope", "vertices"}));
  EXPECT_EQ(json["manifold"]["family"], "submanifold");
  EXPECT_EQ(json["manifold"]["variables"], Json::parse(R"(["x","y","z"])"));
  EXPECT_EQ(json["manifold"]["equations"], Json::parse(R"(["x^2+y^2+z^2-1"])"));
  EXPECT_EQ(json["manifold"]["box"], Json::parse(R"([["-2","2"],["-2","2"],["-2","2"]])"));
  EXPECT_EQ(json["manifold"]["vertices"], "manifold");
  EXPECT_EQ(exact(json["manifold"]["slope"]), sample.atlas.slope());
  // (1 + ξ₀)² ≥ 1 + L².
  const Rational stretch = Rational(1) + exact(json["parameters"]["distortion"]);
  EXPECT_GE(square(stretch), Rational(1) + square(sample.atlas.slope()));
  EXPECT_EQ(keys_of(json["levels"]["5"]), (std::vector<std::string>{"route", "contraction", "displacement"}));
  EXPECT_EQ(keys_of(json["levels"]["5i"]), (std::vector<std::string>{"margin"}));
  // s, the skew matrix, Y, ϱ, ζ.
  const ChartData& chart = sample.atlas.chart(Label(3)).data();
  ASSERT_EQ(json["charts"][3].size(), 3U + 3U + 1U + 2U);
  EXPECT_EQ(exact(json["charts"][3][1]), Rational(chart.columns[1]));
  EXPECT_EQ(exact(json["charts"][3][5]), chart.skew[2]);
  EXPECT_EQ(exact(json["charts"][3][6]), chart.preconditioner[0]);
  EXPECT_EQ(exact(json["charts"][3][7]), chart.radius);
  EXPECT_EQ(exact(json["charts"][3][8]), chart.height);
  ASSERT_EQ(json["net"][3].size(), 3U);
  EXPECT_EQ(exact(json["net"][3][2]), chart.centre[2]);
  ASSERT_EQ(json["points"][3].size(), 2U);
  EXPECT_EQ(exact(json["points"][3][1]), sample.run.points.exact(Label(3))[1]);
  EXPECT_TRUE(json["elements"].empty());
  EXPECT_TRUE(json["loops"].empty());
  ASSERT_EQ(json["simplices"][5].size(), 5U);
  EXPECT_EQ(json["simplices"][5][3], 0);
  EXPECT_EQ(json["simplices"][5][4], 0);
}

TEST(Content, OfAMeshHasItsVerticesAsCentres) {
  const auto& sample = test::sphere_run();
  const FittedCharts charts{sample.atlas.charts(), sample.atlas.slope(), sample.atlas.patch_factor()};
  const test::TemporaryFolder folder;
  const Rational radius = test::ratio(1, 8);
  const std::vector<LabelSimplex<2>> simplices{{0, 1, 2}, {0, 2, 3}};
  Claims claims;
  claims.full_stars.emplace();
  write_certificate<2>(folder / "m.json",
                       content_of<2>(sample.atlas.manifold(), charts, radius, simplices, sample.parameters, claims));
  const Json json = Json::parse(bytes_of(folder / "m.json"));
  EXPECT_EQ(json["manifold"]["vertices"], "given");
  EXPECT_EQ(json["levels"], Json::parse(R"({"1f":{}})"));
  EXPECT_EQ(json["points"][3], Json::parse(R"(["0","0"])"));
  EXPECT_EQ(exact(json["net"][3][2]), charts.charts[3].data().centre[2]);
  EXPECT_EQ(json["simplices"], Json::parse("[[0,1,2,0,0],[0,2,3,0,0]]"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
