#include "proofs/certificate/writer.hpp"

#include <gtest/gtest.h>
#include <nettle/sha2.h>

#include <nlohmann/json.hpp>

#include "tests/proofs/certificate/small_run.hpp"

namespace delcert {
namespace {

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
    const TemporaryFolder folder;
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
                                            "net_simplices", "points", "stars", "sha256"}));
  std::vector<std::string> parameters;
  for (const auto& [key, value] : json.at("parameters").items()) parameters.push_back(key);
  EXPECT_EQ(parameters,
            (std::vector<std::string>{"mode", "candidates", "seed", "sampling_radius", "separation", "radius_variation",
                                      "distortion", "perturbation", "flake_parameter_squared", "tolerance"}));
  EXPECT_EQ(json.at("net").size(), small_run().atlas.size());
  EXPECT_EQ(json.at("stars").size(), small_run().atlas.size());
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
  const TemporaryFolder folder;
  again.write(folder / "again.json");
  EXPECT_EQ(bytes_of(folder / "again.json"), certificate_bytes());
}

TEST(Writer, StarsAreSortedAndOfOtherLabels) {
  const auto json = nlohmann::json::parse(certificate_bytes());
  std::uint32_t label = 0;
  for (const auto& star : json.at("stars")) {
    const auto simplices = star.get<std::vector<std::vector<std::uint32_t>>>();
    EXPECT_TRUE(std::is_sorted(simplices.begin(), simplices.end()));
    for (const auto& simplex : simplices) {
      EXPECT_EQ(simplex.size(), 2U);
      EXPECT_TRUE(std::is_sorted(simplex.begin(), simplex.end()));
      EXPECT_EQ(std::count(simplex.begin(), simplex.end(), label), 0);
    }
    ++label;
  }
}

TEST(Writer, LeavesOutTheWitnessOfALevelThatIsNotClaimed) {
  const TemporaryFolder folder;
  const Claims claims = small_run().claims({"1", "2"});
  write_certificate<2>(folder / "c.json", {small_run().manifold, small_run().parameters, small_run().atlas,
                                           small_run().density.simplices, small_run().run, claims});
  const auto json = nlohmann::json::parse(bytes_of(folder / "c.json"));
  EXPECT_TRUE(json.at("net_simplices").empty());
  EXPECT_EQ(json.at("levels").size(), 2U);
}

}  // namespace
}  // namespace delcert
