#include "proofs/certification/distortion_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational ratio(long a, long b) { return Rational(a) / Rational(b); }

SpaceFormDistortion sample() {
  SpaceFormDistortion found;
  found.transitions = {0.15625, {0.125, 0.1328125}};
  found.metric = 0.0625;
  found.farthest = ratio(59, 100);
  found.needed = 0.125;
  found.stability = StabilityMargin{ratio(1, 2), ratio(1, 4), ratio(1, 1000), ratio(1, 10), ratio(1, 2000)};
  found.ledger = constants_for(Dimension(2), Rational(1), ratio(1, 4));
  found.net = {1, Rational(3), ratio(1, 10), 877};
  found.demand = riemannian_demand(found.ledger, found.net);
  found.tolerance = ratio(1, 50);
  found.stars = StarMargins{ratio(1, 100), ratio(1, 8), ratio(1, 10)};
  return found;
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(DistortionReport, says_what_is_known_and_what_is_asked_for) {
  const std::string text = distortion_text(sample());
  for (const char* part :
       {"ξ₀ ≤ 0.1329 (by each chart alone ≤ 0.1563", "some pair has ≥ 0.125", "η ≤ 0.0625\n", "ledger ", "  877\n",
        "  1/10\n", "≤ 2^-509 ", "≤ 2^-264.5 ", "≤ 0.0625\n", "  1/50\n", "≥ 0.1\n", "≥ 0.125\n"})
    EXPECT_TRUE(mentions(text, part)) << part << "\n" << text;
}

TEST(DistortionReport, margins_are_negative_positive_or_unknown) {
  SpaceFormDistortion found = sample();
  EXPECT_TRUE(mentions(distortion_text(found), "by ≤ 0.1: margin ≥ -0.099\n"));
  EXPECT_TRUE(mentions(distortion_text(found), "by ≤ 0.0005: margin ≥ 0.0005\n"));
  auto json = distortion_json(found);
  EXPECT_EQ(json["stability"]["transitions"]["is_enough"], false);
  EXPECT_EQ(json["stability"]["charts"]["is_enough"], true);
  EXPECT_EQ(json["stability"]["charts"]["margin"]["exact"], "1/2000");
  EXPECT_EQ(json["stability"]["charts"]["margin"]["bound"], "lower");
  EXPECT_EQ(json["stability"]["charts"]["at_most"]["bound"], "upper");
  found.stability->by_transitions.reset();
  EXPECT_TRUE(mentions(distortion_text(found), "by an unknown amount"));
  EXPECT_TRUE(distortion_json(found)["stability"]["transitions"].is_null());
  found.stability.reset();
  EXPECT_FALSE(mentions(distortion_text(found), "stability"));
  EXPECT_FALSE(distortion_json(found).contains("stability"));
}

TEST(DistortionReport, has_logarithms_as_bounds) {
  const auto json = distortion_json(sample());
  EXPECT_EQ(json["hypotheses_2"]["distortion_bound_log2"][0]["value"], -509);
  EXPECT_EQ(json["theorem_3"]["is_met"], false);
  const auto& radius = json["theorem_3"]["sampling_radius_log2"];
  EXPECT_LT(radius[0]["value"].get<double>(), radius[1]["value"].get<double>());
  EXPECT_EQ(radius[0]["bound"], "lower");
  EXPECT_EQ(radius[1]["bound"], "upper");
}

TEST(DistortionReport, refuses_theory_with_numbers) {
  const std::string text = theory_refusal(sample().ledger, {1, Rational(3), ratio(1, 10), 877});
  for (const char* part : {"Theorem 3 asks for a sampling radius of ", "for at least 2^",
                           "a distortion of 2^-509 at most", "here it is 1/10 with 877 points: use --mode measured"})
    EXPECT_TRUE(mentions(text, part)) << part << "\n" << text;
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
