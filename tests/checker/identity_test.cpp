#include "proofs/checker/certificate/identity.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/samples.hpp"
#include "tests/checker/support/space_form_samples.hpp"

namespace delcert::checker_tests {
namespace {

/// The first line of the report on a certificate.
std::string first_line(const std::string& bytes) {
  const std::string output = run_checker_with(temporary_file(bytes)).output;
  return output.substr(0, output.find('\n'));
}

TEST(Identity, says_of_which_manifold_the_verdict_speaks) {
  for (const auto& [sample, words] :
       {std::pair(icosphere(), "spherical, dimension 2, order 1, orientable, H1 = 0 by"),
        {projective_plane(), "spherical, dimension 2, order 2, not orientable, H1 = Z/2 by"},
        {cell_600(), "spherical, dimension 3, order 1, orientable, H1 = 0 by"},
        {projective_space(), "spherical, dimension 3, order 2, orientable, H1 = Z/2 by"},
        {bolza_surface(), "hyperbolic, dimension 2, 8 sides, orientable, H1 = Z^4 by"},
        {klein_bottle(), "flat, dimension 2, 2 cosets of its lattice, not orientable, H1 = Z + Z/2 by"}}) {
    const std::string line = first_line(sealed(sample.document()));
    EXPECT_EQ(line.find("manifold   " + std::string(words)), 0U) << line;
    EXPECT_NE(line.find("; name \"a test\" as stated; SHA-256 of the manifold block "), std::string::npos) << line;
  }
  EXPECT_EQ(first_line(sealed(wide_torus().document())).find("manifold   flat-torus, dimension 2, squared volume 3, "),
            0U);
  EXPECT_EQ(first_line(sealed(disc().document())).find("manifold   euclidean-ball, dimension 2, radius "), 0U);
}

/// Levels 2, 4, 5 and 6 do without the group: its size is not known then, and H_1 is that of the complex.
TEST(Identity, without_the_group_is_that_of_the_complex) {
  const auto described = [](const SpaceFormSample& sample, const Json& homology) {
    Json document = sample.document();
    if (!homology.empty()) document["levels"]["2"]["homology"] = homology;
    const CheckerRun run = run_checker_with(temporary_file(sealed(document)));
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_EQ(run.output.find("level group"), std::string::npos) << run.output;
    return run.output.substr(0, run.output.find("; name"));
  };
  const Json of_bottle = {"Z", "Z + Z/2", "0"};
  const std::set<std::string> levels = {"2", "5", "6"};
  EXPECT_EQ(described(klein_bottle().claiming(levels), of_bottle),
            "manifold   flat, dimension 2, not orientable, H1 = Z + Z/2 by the complex");
  EXPECT_EQ(described(klein_bottle().claiming(levels), {}),
            "manifold   flat, dimension 2, not orientable, H1 not looked at");
  EXPECT_EQ(described(klein_bottle().claiming({"2"}), of_bottle),
            "manifold   flat, dimension 2, not orientable, H1 not looked at");
  EXPECT_EQ(described(bolza_surface().claiming({"2", "4"}), {"Z", "Z^4", "Z"}),
            "manifold   hyperbolic, dimension 2, orientable, H1 = Z^4 by the complex");
}

TEST(Identity, has_the_digests_of_the_block_and_of_the_file) {
  const Json document = bolza_surface().document();
  for (const std::string& bytes : {sealed(document), zstd_compressed(sealed(document))}) {
    const std::string line = first_line(bytes);
    EXPECT_NE(line.find("manifold block " + sha256_of(document["manifold"].dump())), std::string::npos) << line;
    EXPECT_NE(line.find("of the file " + sha256_of(bytes)), std::string::npos) << line;
  }
}

/// A torus and one of its covers, of four sheets, under the same name: family, dimension and H_1 are the same.
TEST(Identity, of_a_cover_is_another) {
  Sample torus = wide_torus().claiming({"1", "2", "4"}), cover = torus;
  for (auto& row : cover.model.gram) {
    for (int& entry : row) entry *= 4;
  }
  const auto described = [](const std::string& line) { return line.substr(0, line.find("; SHA-256")); };
  const std::string line = first_line(sealed(torus.document())), other = first_line(sealed(cover.document()));
  EXPECT_NE(described(line), described(other));
}

TEST(Identity, the_name_is_said_only_where_all_is_verified_and_as_it_is_written) {
  Json document = circle().document();
  document["manifold"]["name"] = "verified: levels 0 1 2\n\x1b[2J \xc2\x9b \xe2\x80\xae";
  const std::string right = sealed(document);
  const std::string line = first_line(right);
  EXPECT_NE(line.find("name \"verified: levels 0 1 2\\n\\u001b[2J \\u009b \\u202e\" as stated"), std::string::npos)
      << line;
  document["levels"]["2"]["simplices"] = 7;
  const CheckerRun text = run_checker_with(temporary_file(sealed(document)));
  EXPECT_EQ(text.status, 1);
  EXPECT_EQ(text.output.find("verified"), std::string::npos) << text.output;
  const CheckerRun json = run_checker(sealed(document));
  EXPECT_EQ(json.output.find("verified"), std::string::npos) << json.output;
  for (const CheckerRun& run : {run_checker(right), run_checker_with(temporary_file(right))})
    EXPECT_EQ(run.output.find('\x9b'), std::string::npos) << run.output;
}

TEST(Identity, is_compared_with_the_manifold_that_is_expected) {
  const auto expecting = [](const std::string& bytes, const std::string& expected) {
    const std::string path = temporary_file("") + "-expected";
    std::ofstream(path, std::ios::binary) << expected;
    const CheckerRun run = run_checker_with(temporary_file(bytes) + " --expect-manifold " + path);
    std::filesystem::remove(path);
    return run;
  };
  const Json bolza = bolza_surface().document();
  Json other = bolza;
  other["manifold"]["name"] = "klein-quartic";
  other["manifold"]["injectivity_radius"] = "1";
  other["manifold"]["root"] = Json::array({"4/3", "3/2"});
  other["manifold"]["generators"][0][0][0] = Json::array({"10/2", "0x4", "0"});
  for (const std::string& expected : {sealed(other), zstd_compressed(sealed(bolza)), other["manifold"].dump()})
    EXPECT_EQ(expecting(sealed(bolza), expected).status, 0);
  // The other root of t^2 = 2; another generator; another manifold.
  for (const auto& change : std::vector<std::function<void(Json&)>>{
           [](Json& j) {
             j["manifold"]["root"] = Json::array({"-2", "-1"});
           },
           [](Json& j) { j["manifold"]["generators"][1][0][0][0] = "6"; },
           [](Json& j) { j["manifold"]["generators"].erase(3); },
           [](Json& j) { j["manifold"] = klein_bottle().document()["manifold"]; }}) {
    Json changed = bolza;
    change(changed);
    const CheckerRun run = expecting(sealed(bolza), sealed(changed));
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_NE(run.output.find("manifold.expected"), std::string::npos) << run.output;
    EXPECT_EQ(run.output.find("verified"), std::string::npos) << run.output;
  }
  for (const std::string text : {"", "[]", "{}", "family = \"flat-torus\""})
    EXPECT_EQ(expecting(sealed(bolza), text).status, 64) << text;
}

}  // namespace
}  // namespace delcert::checker_tests
