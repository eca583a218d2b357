#include "proofs/certification/report_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;

TEST(ReportJson, has_every_level_that_is_claimed_with_bounds_and_other_entries) {
  const std::vector<ClaimedLevel> levels{
      {"1", {{"thickness", {{Rational(1) / Rational(3), Margin::Side::lower, Margin::Unit::one}}, ""}}},
      {"2", {{"closed", {}, "true"}}},
      {"6",
       {{"bilipschitz",
         {{Rational(1), Margin::Side::lower, Margin::Unit::one}, {Rational(2), Margin::Side::upper, Margin::Unit::one}},
         ""}}}};
  const Json json = levels_json(levels, Rational(1));
  EXPECT_EQ(json.size(), 3U);
  EXPECT_EQ(json["1"]["thickness"]["exact"], "1/3");
  EXPECT_EQ(json["2"], Json::parse(R"({"closed":true})"));
  EXPECT_EQ(json["6"]["bilipschitz"].size(), 2U);
  EXPECT_EQ(json["6"]["bilipschitz"][1]["bound"], "upper");
}

TEST(ReportJson, says_what_was_measured_of_simplices_only_if_it_was) {
  RunReport report;
  report.sampling_radius = Rational(1) / Rational(4);
  report.riemannian.emplace().holds = Verdict::undecided;
  EXPECT_FALSE(Json::parse(report_json(report))["measures"].contains("riemannian_simplices"));
  report.riemannian->holds = Verdict::proved;
  report.riemannian->thickness = 0.25;
  report.riemannian->star_radius = 0.5;
  const Json measures = Json::parse(report_json(report))["measures"];
  EXPECT_EQ(measures["riemannian_simplices"]["thickness"]["value"], 0.25);
  EXPECT_EQ(measures["riemannian_simplices"]["star_radius"]["in_sampling_radii"], 2);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
