#include "apps/proof_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace delcert {
namespace DELCERT_THIS_FILE {

class ProofReport : public testing::Test {
 protected:
  ProofReport() {
    claim_.name = "c";
    step_.name = "s";
    step_.lines = "6-7";
    step_.status = ClaimStatus::paper;
    outcome_.method = "polynomial";
    outcome_.boxes = 3;
  }
  Claim claim_;
  Step step_;
  StepOutcome outcome_;
  Vacuity vacuity_;
};

TEST_F(ProofReport, of_what_is_proved) {
  outcome_.verdict = Verdict::proved;
  vacuity_.verdict = Verdict::refuted;
  vacuity_.point = {{"x", Rational(1)}};
  EXPECT_EQ(step_row(claim_, step_, outcome_, vacuity_, 0.25),
            "| c / s | 6-7 | paper | polynomial | proved | 3 | 0.25 |  |\n");
  EXPECT_FALSE(step_json(claim_, step_, outcome_, vacuity_).contains("counterexample"));
}

TEST_F(ProofReport, of_what_is_proved_says_whether_it_is_about_anything) {
  outcome_.verdict = Verdict::proved;
  vacuity_.premises = "x > 2";
  EXPECT_NE(
      step_row(claim_, step_, outcome_, vacuity_, 0).find("| proved | 3 | 0.00 | undecided whether ever: x > 2 |"),
      std::string::npos);
  EXPECT_EQ(step_json(claim_, step_, outcome_, vacuity_)["undecided_whether_ever"], "x > 2");
  vacuity_.verdict = Verdict::proved;
  EXPECT_NE(step_row(claim_, step_, outcome_, vacuity_, 0).find("| vacuous | 3 | 0.00 | never: x > 2 |"),
            std::string::npos);
  EXPECT_EQ(step_json(claim_, step_, outcome_, vacuity_)["verdict"], "vacuous");
  vacuity_.verdict = Verdict::refuted;
  vacuity_.point = {{"x", Rational(1)}};
  EXPECT_EQ(step_json(claim_, step_, outcome_, vacuity_)["verdict"], "proved");
  EXPECT_EQ(step_json(claim_, step_, outcome_, vacuity_)["point"]["x"], "1");
}

TEST_F(ProofReport, of_what_is_refuted_shows_where) {
  outcome_.verdict = Verdict::refuted;
  EXPECT_NE(step_row(claim_, step_, outcome_, vacuity_, 0).find("| refuted | 3 | 0.00 | false |"), std::string::npos);
  outcome_.counterexample = {{"x", Rational(1) / Rational(3)}, {"y", Rational(2)}};
  EXPECT_NE(step_row(claim_, step_, outcome_, vacuity_, 0).find("| false at x = 1/3, y = 2 |"), std::string::npos);
  EXPECT_EQ(step_json(claim_, step_, outcome_, vacuity_)["counterexample"].dump(), R"({"x":"1/3","y":"2"})");
}

TEST_F(ProofReport, of_what_is_undecided_shows_what_is_left) {
  outcome_.left = {"x in [0, 1]"};
  EXPECT_NE(step_row(claim_, step_, outcome_, vacuity_, 0).find("| left: x in [0, 1] |"), std::string::npos);
  outcome_.left.emplace_back("x in [1, 2]");
  EXPECT_NE(step_row(claim_, step_, outcome_, vacuity_, 0).find("| left among others: x in [0, 1] |"),
            std::string::npos);
  EXPECT_EQ(step_json(claim_, step_, outcome_, vacuity_)["left"].size(), 2U);
}

TEST_F(ProofReport, of_slack) {
  Slack slack;
  slack.constant = "k";
  slack.stated = Rational(3);
  EXPECT_EQ(slack_row(claim_, step_, slack), "| c / s | k | 3 | – | – | 0 |\n");
  EXPECT_TRUE(slack_json(slack)["proved"].is_null());
  slack.proved = Rational(2);
  slack.refuted = Rational(2001) / Rational(1001);
  slack.counterexample = {{"x", Rational(1)}};
  EXPECT_EQ(slack_row(claim_, step_, slack), "| c / s | k | 3 | 2 | 2001/1001 | 0 |\n");
  EXPECT_EQ(slack_json(slack)["sharp"], true);
  EXPECT_EQ(slack_json(slack)["counterexample"].dump(), R"({"x":"1"})");
}

TEST_F(ProofReport, heads_fit_their_rows) {
  const auto columns = [](const std::string& row) { return std::count(row.begin(), row.end(), '|'); };
  const std::string head = step_table_head();
  EXPECT_EQ(columns(head), 2 * columns(step_row(claim_, step_, outcome_, vacuity_, 0)));
  Slack slack;
  EXPECT_EQ(columns(slack_table_head()), 2 * columns(slack_row(claim_, step_, slack)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
