// What would take hours or all memory ends soon: by a rejection, or undecided.

#include <gtest/gtest.h>

#include <ctime>
#include <random>

#include "proofs/checker/geometry/homology.hpp"
#include "proofs/checker/report/budget.hpp"
#include "proofs/checker/report/report.hpp"
#include "tests/checker/support/metric_field_documents.hpp"
#include "tests/checker/support/samples.hpp"
#include "tests/checker/support/space_form_samples.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

/// The run ends with one of these statuses within ten seconds of processor time and a gibibyte.
CheckerRun expect_soon(const std::string& bytes, const std::set<int>& statuses) {
  const CheckerRun run = run_checker(bytes);
  EXPECT_TRUE(statuses.contains(run.status)) << run.status << "\n" << run.output.substr(0, 2000);
  EXPECT_LT(run.seconds, 10) << run.output.substr(0, 2000);
  EXPECT_LT(run.peak_kib, 1 << 20);
  return run;
}

std::set<std::string> levels_looked_at(const CheckerRun& run) {
  std::set<std::string> result;
  const auto json = nlohmann::json::parse(run.output, nullptr, false);
  for (const auto& level : json["levels"]) result.insert(level["level"].get<std::string>());
  return result;
}

TEST(Work, of_a_level_whose_base_is_rejected_is_not_done) {
  Json document = wide_torus().document();
  document["parameters"]["sampling_radius"] = "1/3";
  const CheckerRun run = expect_soon(sealed(document), {1});
  EXPECT_TRUE(run.rules.contains("0.patch")) << run.output;
  EXPECT_EQ(levels_looked_at(run), (std::set<std::string>{"0", "1", "2", "4", "5", "6"})) << run.output;
  document = wide_torus().document();
  document["levels"]["1"]["protection"] = "1";
  EXPECT_EQ(levels_looked_at(expect_soon(sealed(document), {1})),
            (std::set<std::string>{"0", "1", "2", "3", "4", "5", "6"}));
  document = icosphere().document();
  document["levels"]["4"]["circumradius"] = "1/100";
  EXPECT_EQ(levels_looked_at(expect_soon(sealed(document), {1})),
            (std::set<std::string>{"group", "1", "2", "2s", "4", "5", "6"}));
}

/// Without the rules of level 0 that reject it before, the search of level 3 would take hours.
TEST(Work, of_level_3_is_bounded) {
  Json document = wide_torus().claiming({"0", "3"}).document();
  document["parameters"]["sampling_radius"] = "1/3";
  const CheckerRun run = run_checker(sealed(document), "0.patch");
  EXPECT_LT(run.seconds, 60) << run.output.substr(0, 2000);
  EXPECT_NE(run.status, 0);
}

/// Triangles of 90 labels, each edge in many.
std::vector<checker::LabelSet> random_triangles(int number) {
  std::mt19937_64 random(1);
  std::vector<checker::LabelSet> result;
  while (static_cast<int>(result.size()) < number) {
    std::set<std::uint32_t> labels;
    while (labels.size() < 3) labels.insert(static_cast<std::uint32_t>(random() % 90));
    checker::LabelSet simplex{};
    std::copy(labels.begin(), labels.end(), simplex.begin());
    result.push_back(simplex);
  }
  return result;
}

TEST(Work, of_homology_is_bounded) {
  const test::Upwards upwards;
  checker::Budget::open(90);
  for (const int number : {500, 2000, 4000, 4500, 20000}) {
    const auto begin = std::clock();
    try {
      EXPECT_EQ(checker::FaceComplex(2, random_triangles(number)).homology().size(), 3U);
    } catch (const checker::Undecided&) {
    }
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 10) << number;
  }
}

TEST(Work, of_homology_is_not_done_for_what_is_no_manifold) {
  Sample sample = wide_torus().claiming({"1", "2"});
  std::vector<Labels> triangles;
  for (const checker::LabelSet& simplex : random_triangles(4200))
    triangles.push_back({static_cast<int>(simplex[0]), static_cast<int>(simplex[1]), static_cast<int>(simplex[2])});
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  sample.model.net.resize(90);
  sample.model.points.resize(90);
  sample.model.interior.resize(90);
  sample.model.stars = stars_of(triangles, sample.model.interior);
  Json document = sample.document();
  document["levels"]["2"]["homology"] = Json::array({"Z", "0", "Z^7"});
  const CheckerRun run = expect_soon(sealed(document), {1});
  EXPECT_TRUE(run.rules.contains("core.facets")) << run.output.substr(0, 2000);
  EXPECT_FALSE(run.rules.contains("2.homology"));
}

TEST(Work, of_a_point_near_the_rim_of_the_disk_is_bounded) {
  for (const char* coordinate : {"0x1.fp0", "0x1.ffp0", "0x1.ffffp0", "0x1.ffffffffffp0"}) {
    Json document = bolza_surface().document();
    document["net"][7] = Json::array({coordinate, "0"});
    expect_soon(sealed(document), {1, 2});
  }
}

TEST(Work, of_waves_is_bounded) {
  Json document = flat_document();
  const Json zero = Json::parse(R"({"frequency":[0,0],"cosine":[["0","0"],["0","0"]],"sine":[["0","0"],["0","0"]]})");
  for (int k = 0; k < 20000; ++k) document["manifold"]["waves"].push_back(zero);
  expect_soon(sealed(document), {1, 2});
}

TEST(Work, of_compressed_bytes_is_bounded) {
  for (const std::string unit : {"[", "\"0\",", "[[\"0\",\"0\"],", " "}) {
    std::string text = R"({"format":"delcert-certificate","version":1,"software":{"delcert":")";
    while (text.size() < 900'000'000 / 8) text += unit;
    expect_soon(zstd_compressed(text), {3});
  }
  // A document of the right form but for its length.
  const std::string whole = sealed(circle().document());
  const std::size_t place = whole.find("\"net\":[") + 7;
  std::string points;
  while (points.size() < 100'000'000) points += "[\"0\"],";
  expect_soon(zstd_compressed(whole.substr(0, place) + points + whole.substr(place)), {3});
}

TEST(Work, of_large_numbers_and_fields_is_bounded) {
  Json document = bolza_surface().document();
  Json field = Json::array();
  for (int k = 0; k < 2000; ++k) field.push_back(std::to_string(1 + k * k % 101));
  document["manifold"]["field"] = field;
  expect_soon(sealed(document), {2, 3});
  document = circle().document();
  document["points"][3][0] = "1/" + std::string(5'000'000, '7');
  expect_soon(sealed(document), {1, 2, 3});
}

TEST(Work, ends_at_the_limits_of_time_and_memory) {
  const std::string file = temporary_file(sealed(cubic_torus().document()));
  const CheckerRun late = run_checker_with(file + " --time-limit 0.01");
  EXPECT_EQ(late.status, 2) << late.output;
  EXPECT_EQ(late.output.find("verified"), std::string::npos) << late.output;
  EXPECT_NE(late.output.find("undecided: levels limit"), std::string::npos) << late.output;
  EXPECT_LT(late.seconds, 2);
  const CheckerRun json = run_checker_with(file + " --json --time-limit 0.01");
  EXPECT_EQ(nlohmann::json::parse(json.output)["exit"], 2);
  EXPECT_EQ(run_checker_with(file + " --quiet --time-limit 0.01").output, "");
  const CheckerRun large = run_checker_with(file + " --memory-limit 24");
  EXPECT_EQ(large.status, 2) << large.output;
  EXPECT_NE(large.output.find("the limit of memory was reached"), std::string::npos) << large.output;
  const std::string small = temporary_file(sealed(circle().document()));
  EXPECT_EQ(run_checker_with(small + " --time-limit 60 --memory-limit 1024").status, 0);
  for (const char* option : {"--time-limit 0", "--time-limit -1", "--time-limit x", "--memory-limit 0"})
    EXPECT_EQ(run_checker_with(small + " " + option).status, 64) << option;
}

}  // namespace
}  // namespace delcert::checker_tests
