#include "proofs/certificate/writer.hpp"

#include <gtest/gtest.h>
#include <nettle/sha2.h>
#include <zstd.h>

#include <nlohmann/json.hpp>

#include "delcert_version.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/self_test.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

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
  EXPECT_EQ(keys, all_levels());
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
  write_certificate<2>(folder / "c.json", {disk, small_run().parameters, small_run().atlas,
                                           small_run().density.simplices, small_run().run, claims});
  const auto json = nlohmann::ordered_json::parse(bytes_of(folder / "c.json"));
  EXPECT_EQ(json.at("manifold").dump(),
            R"({"name":"a \"disk\"","family":"euclidean-ball","dimension":2,"radius":"7/3"})");
}

TEST(Writer, NamesModesAndCandidateRulesAsInFiles) {
  EXPECT_EQ(name_of(RunMode::theory), "theory");
  EXPECT_EQ(name_of(RunMode::measured), "measured");
  EXPECT_EQ(name_of(RunMode::none), "none");
  EXPECT_EQ(name_of(CandidateRule::pruned), "pruned");
  EXPECT_EQ(name_of(CandidateRule::whole), "whole");
  EXPECT_EQ(name_of(CandidateRule::printed), "printed");
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
  write_certificate<2>(folder / "c.json", {small_run().manifold, small_run().parameters, small_run().atlas,
                                           small_run().density.simplices, small_run().run, claims});
  const auto json = nlohmann::json::parse(bytes_of(folder / "c.json"));
  EXPECT_TRUE(json.at("net_simplices").empty());
  EXPECT_EQ(json.at("levels").size(), 2U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
