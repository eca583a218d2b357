#include "proofs/certificate/writer.hpp"

#include <gtest/gtest.h>
#include <nettle/sha2.h>
#include <zstd.h>

#include <nlohmann/json.hpp>

#include "delcert_version.hpp"
#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/self_test.hpp"
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

std::string hexadecimal_sha256(std::string_view bytes) {
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  std::string result;
  for (const unsigned byte : digest) {
    constexpr const char* digits = "0123456789abcdef";
    result += digits[byte / 16];
    result += digits[byte % 16];
  }
  return result;
}

std::string certificate_bytes() {
  static const std::string bytes = [] {
    const test::TemporaryFolder folder;
    small_run().write(folder / "c.json");
    return bytes_of(folder / "c.json");
  }();
  return bytes;
}

TEST(Writer, KeysStandInTheOrderOfTheFormat) {
  const auto json = nlohmann::ordered_json::parse(certificate_bytes());
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{"format", "version", "software", "manifold", "parameters", "levels", "net",
                                            "net_simplices", "points", "elements", "simplices", "loops", "sha256"}));
  std::vector<std::string> parameters;
  for (const auto& [key, value] : json.at("parameters").items()) parameters.push_back(key);
  EXPECT_EQ(parameters,
            (std::vector<std::string>{"mode", "candidates", "seed", "sampling_radius", "separation", "radius_variation",
                                      "distortion", "perturbation", "flake_parameter_squared", "tolerance"}));
  EXPECT_EQ(json.at("net").size(), small_run().atlas.size());
  EXPECT_EQ(json.at("simplices").size(), small_run().run.complex.simplices().size());
}

Rational number(const nlohmann::json& text) { return parse_exact(text.get<std::string>()); }

TEST(Writer, SaysWhatWasRun) {
  const auto json = nlohmann::json::parse(certificate_bytes());
  EXPECT_EQ(json.at("format"), "delcert-certificate");
  EXPECT_EQ(json.at("version"), 2);
  EXPECT_EQ(json.at("software").at("delcert"), version);
  for (const auto& [name, value] : library_versions()) EXPECT_EQ(json.at("software").at(name), value);
  EXPECT_EQ(json.at("manifold"), nlohmann::json::parse(R"({"name":"torus-2","family":"flat-torus","dimension":2,
                                                           "gram":[["1","0"],["0","1"]]})"));
  const auto& parameters = json.at("parameters");
  const PerturbationParameters& algorithm = small_run().parameters.algorithm;
  EXPECT_EQ(parameters.at("mode"), "theory");
  EXPECT_EQ(parameters.at("candidates"), "pruned");
  EXPECT_EQ(parameters.at("seed"), std::to_string(algorithm.seed));
  EXPECT_EQ(number(parameters.at("sampling_radius")), small_run().atlas.sampling_radius());
  EXPECT_EQ(number(parameters.at("separation")), algorithm.separation);
  EXPECT_EQ(number(parameters.at("radius_variation")), Rational(0));
  EXPECT_EQ(number(parameters.at("distortion")), Rational(0));
  EXPECT_EQ(number(parameters.at("perturbation")), algorithm.perturbation);
  EXPECT_EQ(number(parameters.at("flake_parameter_squared")), small_run().parameters.squared_flake_parameter);
  EXPECT_EQ(number(parameters.at("tolerance")), algorithm.tolerance);
}

TEST(Writer, HasTheLevelsWithTheirMarginsInOrder) {
  const auto levels = nlohmann::ordered_json::parse(certificate_bytes()).at("levels");
  std::vector<std::string> keys;
  for (const auto& [key, value] : levels.items()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{"0", "1", "2", "2s", "3", "4", "5", "6"}));
  const StarMargins& margins = small_run().run.protection.margins.value();
  EXPECT_EQ(levels.at("0").dump(), R"({"hypotheses_2":true})");
  EXPECT_EQ(levels.at("1").size(), 3U);
  EXPECT_EQ(number(levels.at("1").at("protection")), margins.protection);
  EXPECT_EQ(number(levels.at("1").at("thickness")), margins.thickness);
  EXPECT_EQ(number(levels.at("1").at("circumradius")), margins.circumradius);
  EXPECT_EQ(levels.at("2").dump(), "{\"simplices\":" + std::to_string(small_run().run.complex.simplices().size()) +
                                       R"(,"euler_characteristic":0,"closed":true,"homology":["Z","Z^2","Z"]})");
  EXPECT_EQ(levels.at("2s").dump(), "{}");
  EXPECT_EQ(levels.at("3").at("tested"), small_run().claims().no_forbidden.value());
  EXPECT_EQ(levels.at("4").dump(), "{}");
  EXPECT_EQ(levels.at("5").dump(), R"({"route":"space-form"})");
  EXPECT_EQ(levels.at("6").dump(), R"({"self_delaunay":true,"bilipschitz":"1"})");
}

TEST(Writer, HasEveryPointExactly) {
  const auto json = nlohmann::json::parse(certificate_bytes());
  for (std::uint32_t index = 0; index < small_run().atlas.size(); ++index) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_EQ(number(json.at("net")[index][axis]), small_run().atlas.net().exact(Label(index))[axis]);
      EXPECT_EQ(number(json.at("points")[index][axis]), small_run().run.points.exact(Label(index))[axis]);
    }
  }
  const auto& simplices = small_run().density.simplices;
  ASSERT_EQ(json.at("net_simplices").size(), simplices.size());
  for (std::size_t at = 0; at < simplices.size(); ++at) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(json.at("net_simplices")[at][corner], simplices[at][corner].index);
    }
  }
}

TEST(Writer, IsOneLineWithoutWhiteSpaceOutsideStrings) {
  const std::string bytes = certificate_bytes();
  EXPECT_EQ(bytes.find('\n'), bytes.size() - 1);
  bool in_string = false;
  for (const char c : bytes.substr(0, bytes.size() - 1)) {
    if (c == '"') in_string = !in_string;
    EXPECT_FALSE(!in_string && c == ' ');
  }
}

TEST(Writer, SealsWhatStandsBeforeTheSeal) {
  const std::string bytes = certificate_bytes();
  const std::string key = ",\"sha256\":\"";
  const std::size_t at = bytes.rfind(key);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(bytes.substr(at + key.size()), hexadecimal_sha256(std::string_view(bytes).substr(0, at)) + "\"}\n");
}

TEST(Writer, EqualRunsGiveEqualBytes) {
  const SmallRun again;
  const test::TemporaryFolder folder;
  again.write(folder / "again.json");
  EXPECT_EQ(bytes_of(folder / "again.json"), certificate_bytes());
}

TEST(Writer, CompressesTheSameBytesTheSameWay) {
  const test::TemporaryFolder folder;
  small_run().write(folder / "a.json.zst");
  small_run().write(folder / "b.json.zst");
  const std::string packed = bytes_of(folder / "a.json.zst");
  EXPECT_EQ(bytes_of(folder / "b.json.zst"), packed);
  std::string text(certificate_bytes().size() + 1, ' ');
  text.resize(ZSTD_decompress(text.data(), text.size(), packed.data(), packed.size()));
  EXPECT_EQ(text, certificate_bytes());
}

TEST(Writer, DescribesABallByItsRadius) {
  ManifoldDescription disk = small_run().manifold;
  disk.family = ManifoldFamily::euclidean_ball;
  disk.name = "a \"disk\"";
  disk.radius = Rational(Integer(7), Integer(3));
  const test::TemporaryFolder folder;
  const Claims claims = small_run().claims({"1"});
  small_run().write(folder / "c.json", claims, disk);
  const auto json = nlohmann::ordered_json::parse(bytes_of(folder / "c.json"));
  EXPECT_EQ(json.at("manifold").dump(),
            R"({"name":"a \"disk\"","family":"euclidean-ball","dimension":2,"radius":"7/3"})");
}

TEST(Writer, SimplicesAreSortedByTheirIncreasingLabels) {
  const auto json = nlohmann::json::parse(certificate_bytes());
  std::vector<std::vector<std::uint32_t>> labels;
  for (const auto& entry : json.at("simplices")) {
    const auto simplex = entry.get<std::vector<std::uint32_t>>();
    ASSERT_EQ(simplex.size(), 5U);
    labels.emplace_back(simplex.begin(), simplex.begin() + 3);
    EXPECT_TRUE(std::adjacent_find(labels.back().begin(), labels.back().end(), std::greater_equal<>()) ==
                labels.back().end());
  }
  EXPECT_TRUE(std::adjacent_find(labels.begin(), labels.end(), std::greater_equal<>()) == labels.end());
}

TEST(Writer, LeavesOutTheWitnessOfALevelThatIsNotClaimed) {
  const test::TemporaryFolder folder;
  const Claims claims = small_run().claims({"1", "2"});
  small_run().write(folder / "c.json", claims, small_run().manifold);
  const auto json = nlohmann::json::parse(bytes_of(folder / "c.json"));
  EXPECT_TRUE(json.at("net_simplices").empty());
  EXPECT_EQ(json.at("levels").size(), 2U);
}

TEST(Writer, NeedsNoRunAndTheReaderReadsWhatItWrites) {
  const test::TemporaryFolder folder;
  const SpaceForm form = verify_space_form(sphere(2));
  RunParameters parameters;
  parameters.mode = RunMode::measured;
  parameters.algorithm.separation = Rational(1);
  const Rational epsilon(Integer(1), Integer(10));
  const std::vector<std::vector<Rational>> centres{{Rational(0), Rational(1)}, {Rational(1), epsilon}},
      vectors{{epsilon, Rational(0)}, {Rational(0), Rational(0)}};
  const PlacedComplex<2> complex{{{0, 1}, {1, -1}}, {{0, 1, 2, 0, 1}, {0, 1, 3, 2, 0}}, {{{0, 0, 2}, {1, 2, 0}}}};
  Claims claims;
  claims.input = InputClaim{{}, InputClaim::Density{epsilon, Rational(2) * epsilon, Rational(3) * epsilon}};
  claims.stars = StarMargins{epsilon, epsilon, epsilon};
  claims.manifold = ManifoldClaim{};
  claims.stable_stars = StableStarsClaim{epsilon};
  claims.delaunay = DelaunayClaim{DelaunayClaim::Balls{epsilon, epsilon}, {}};
  claims.triangulation = TriangulationClaim{"space-form", TriangulationClaim::RiemannianSimplices{epsilon, epsilon}};
  claims.metric = MetricClaim{true, Rational(0), epsilon, Rational(2)};
  write_certificate<2>(folder / "s.json", {manifold_object(form), parameters, epsilon, claims, 2,
                                           [&](Label at) { return centres[at.value]; },
                                           [&](Label at) { return vectors[at.value]; }, complex});
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

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
