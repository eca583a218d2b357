#include "proofs/certificate/metric_field_writer.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/reader.hpp"
#include "tests/proofs/certificate/metric_field_run.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

Rational exact(const Json& text) { return parse_exact(text.get<std::string>()); }

TEST(MetricFieldWriter, WritesTheKeysOfTheFormatAndTheReaderReadsThem) {
  const auto& sample = sheared_run();
  const TemporaryFolder folder;
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

TEST(MetricFieldWriter, WritesTheMarginsOfLevel4) {
  const auto& sample = flat_run();
  const TemporaryFolder folder;
  std::vector<std::string> reasons;
  const auto claims = sample.claims(reasons);
  sample.write(folder / "m.json", claims);
  const Json json = Json::parse(bytes_of(folder / "m.json"));
  EXPECT_EQ(keys_of(json["levels"]), (std::vector<std::string>{"1", "2", "2s", "4", "5"}));
  EXPECT_EQ(keys_of(json["levels"]["4"]), (std::vector<std::string>{"edge", "margin"}));
  EXPECT_EQ(exact(json["levels"]["4"]["edge"]), claims.delaunay->edge);
  EXPECT_EQ(exact(json["levels"]["4"]["margin"]), claims.delaunay->margin);
  EXPECT_EQ(read_certificate(folder / "m.json").levels.size(), 5U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
