#include "proofs/certificate/space_form_writer.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/reader.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(SpaceFormWriter, GroupsAreWrittenExactly) {
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

TEST(SpaceFormWriter, WritesTheKeysOfTheFormatAndTheReaderReadsThem) {
  const test::TemporaryFolder folder;
  const SpaceForm form = verify_space_form(sphere(2));
  RunParameters parameters;
  parameters.mode = RunMode::measured;
  parameters.algorithm.separation = Rational(1);
  const Rational epsilon(Integer(1), Integer(10));
  const std::vector<Vector<Rational, 2>> centres{{Rational(0), Rational(1)}, {Rational(1), epsilon}},
      vectors{{epsilon, Rational(0)}, {Rational(0), Rational(0)}};
  const PlacedComplex<2> complex{{{0, 1}, {1, -1}}, {{0, 1, 2, 0, 1}, {0, 1, 3, 2, 0}}, {{{0, 0, 2}, {1, 2, 0}}}};
  SpaceFormClaims claims;
  claims.stars = StarMargins{epsilon, epsilon, epsilon};
  claims.manifold = ManifoldClaim{};
  claims.density = claims.reach = epsilon;
  claims.distortion = Rational(2) * epsilon;
  claims.metric_distortion = Rational(3) * epsilon;
  claims.delaunay = {epsilon, epsilon};
  claims.triangulation = true;
  claims.riemannian = {epsilon, epsilon};
  claims.metric = SpaceFormClaims::Metric{Rational(0), epsilon, Rational(2)};
  write_space_form_certificate<2>(folder / "s.json", {form, parameters, epsilon, centres, vectors, complex, claims});
  const Json json = Json::parse(bytes_of(folder / "s.json"));
  EXPECT_EQ(keys_of(json),
            (std::vector<std::string>{"format", "version", "software", "manifold", "parameters", "levels", "net",
                                      "net_simplices", "points", "elements", "simplices", "loops", "sha256"}));
  EXPECT_EQ(keys_of(json["levels"]), (std::vector<std::string>{"0", "1", "2", "2s", "4", "5", "6"}));
  EXPECT_EQ(json["levels"]["0"], Json::parse(R"({"density":"1/10","distortion":"1/5","metric_distortion":"3/10"})"));
  EXPECT_EQ(json["levels"]["5"], Json::parse(R"({"route":"space-form","thickness":"1/10","radius":"1/10"})"));
  EXPECT_EQ(json["levels"]["6"], Json::parse(R"({"self_delaunay":true,"weight":"0","bilipschitz":["1/10","2"]})"));
  EXPECT_EQ(json["net"], Json::parse(R"([["0","1"],["1","1/10"]])"));
  EXPECT_EQ(json["points"], Json::parse(R"([["1/10","0"],["0","0"]])"));
  EXPECT_EQ(json["elements"], Json::parse("[[0,1],[1,-1]]"));
  EXPECT_EQ(json["simplices"], Json::parse("[[0,1,2,0,1],[0,1,3,2,0]]"));
  EXPECT_EQ(json["loops"], Json::parse("[[0,0,2,1,2,0]]"));

  const CertificateSummary read = read_certificate(folder / "s.json");
  EXPECT_EQ(read.family, "spherical");
  EXPECT_EQ(read.manifold.name, form.description.name);
  EXPECT_EQ(read.manifold.dimension, Dimension(2));
  EXPECT_EQ(read.points[0][0], epsilon);
  EXPECT_EQ(read.levels.size(), 7U);
}

TEST(SpaceFormWriter, FamiliesAreNamedByTheirCurvature) {
  EXPECT_EQ(family_of(Curvature::positive), "spherical");
  EXPECT_EQ(family_of(Curvature::zero), "flat");
  EXPECT_EQ(family_of(Curvature::negative), "hyperbolic");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
