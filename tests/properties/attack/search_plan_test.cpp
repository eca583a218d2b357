#include "properties/attack/search_plan.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "properties/attack/twins.hpp"
#include "support/error.hpp"
#include "tests/properties/attack/small_campaign.hpp"
#include "tests/properties/attack/small_claims.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

class Searches : public testing::Test {
 protected:
  void SetUp() override {
    const Claim never = test::claim_about_simplices("never", "given = [\"k = 0\"]\n[[show]]\nclaim = \"k <= 1\"\n");
    plan_.targets = {{test::wrong_claim(), 0, {2, 2}, 40},
                     {never, 0, {2, 2}, 10},
                     {test::right_claim(), 0, {1, 2}, 20},
                     {test::right_claim(), 0, {2, 3}, 30}};
    plan_.seed = 3;
  }

  std::string result() const {
    std::string text;
    const auto found = run_searches(plan_, no_progress());
    for (std::size_t at = 0; at < found.size(); ++at) {
      if (!found[at]) {
        text += "nothing\n";
        continue;
      }
      text += witness_text(witness_of(plan_.targets[at].claim, 0, found[at]->bindings)) +
              std::to_string(found[at]->evaluations) + (is_refuted(found[at]->verdict) ? " refuted" : "") +
              (found[at]->is_equality ? " equality" : "") + "\n";
    }
    return text;
  }
  std::string error_of() const {
    try {
      (void)run_searches(plan_, no_progress());
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  std::string log_text() const {
    std::ifstream stream(plan_.log, std::ios::binary);
    std::stringstream buffer;
    buffer << stream.rdbuf();
    return buffer.str();
  }

  test::TemporaryFolder folder_;
  SearchPlan plan_;
};

TEST_F(Searches, find_what_single_ones_find_whatever_the_threads) {
  const std::string one = result();
  for (const unsigned threads : {0U, 2U, 8U}) {
    plan_.threads = threads;
    EXPECT_EQ(result(), one) << threads;
  }
  const auto found = run_searches(plan_, no_progress());
  ASSERT_EQ(found.size(), 4U);
  EXPECT_FALSE(found[1].has_value());
  const auto alone = tighten(plan_.targets[3].claim, 0, {2, 3}, 30, 3, no_progress());
  EXPECT_EQ(found[3]->ratio.lower, alone->ratio.lower);
  EXPECT_EQ(found[3]->evaluations, alone->evaluations);
  plan_.seed = 4;
  EXPECT_NE(result(), one);
}

TEST_F(Searches, go_on_from_whatever_the_log_has) {
  const std::string one = result();
  plan_.log = folder_ / "log.jsonl";
  EXPECT_EQ(result(), one);
  const std::string whole = log_text();
  for (std::size_t length = 0; length <= whole.size(); length += 1 + whole.size() / 9) {
    std::ofstream(plan_.log, std::ios::binary) << whole.substr(0, length);
    EXPECT_EQ(result(), one) << length;
    // And from the log alone.
    EXPECT_EQ(result(), one) << length;
  }
}

TEST_F(Searches, interrupted_they_keep_what_is_finished) {
  const std::string one = result();
  plan_.log = folder_ / "log.jsonl";
  plan_.targets[3].evaluations = 1000000000;
  const Progress interrupt = [](std::string_view, std::size_t done, std::size_t) {
    if (done == 3) throw std::runtime_error("interrupted");
  };
  EXPECT_THROW((void)run_searches(plan_, interrupt), std::runtime_error);
  const std::string text = log_text();
  // The first line, that of the process, and three searches.
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
}

TEST_F(Searches, refuse_the_log_of_others) {
  plan_.log = folder_ / "log.jsonl";
  (void)result();
  EXPECT_EQ(error_of(), "no error");
  const SearchPlan good = plan_;
  plan_.seed = 4;
  EXPECT_NE(error_of().find("another search"), std::string::npos);
  plan_ = good;
  plan_.targets[0].evaluations = 41;
  EXPECT_NE(error_of().find("another search"), std::string::npos);
}

TEST_F(Searches, judge_what_the_log_says_anew) {
  plan_.log = folder_ / "log.jsonl";
  const auto before = run_searches(plan_, no_progress());
  EXPECT_TRUE(is_refuted(before[0]->verdict));
  // Another triangle, one with which the claim holds.
  const auto first = test::lines_of(plan_.log)[0];
  const auto line = [&](std::size_t target, const std::string& conclusion) {
    Witness witness = witness_of(plan_.targets[0].claim, 0, test::triangle_bindings(Rational(1) / Rational(2), 1));
    witness.conclusion = conclusion;
    const nlohmann::ordered_json json{
        {"target", target}, {"evaluations", 7}, {"witness", nlohmann::ordered_json::parse(witness_text(witness))}};
    test::write_lines(plan_.log, {first, json});
  };
  line(0, "radius");
  const auto after = run_searches(plan_, no_progress());
  EXPECT_TRUE(is_proved(after[0]->verdict));
  EXPECT_EQ(after[0]->evaluations, 7U);
  line(9, "radius");
  EXPECT_NE(error_of().find("log.jsonl:2: target 9 is none of this search"), std::string::npos) << error_of();
  line(0, "diameter");
  EXPECT_NE(error_of().find("log.jsonl:2: the witness of another conclusion"), std::string::npos) << error_of();
}

TEST_F(Searches, name_the_claim_that_asks_too_much) {
  plan_.targets[2].claim = test::claim_about_simplices("asks-too-much", "[[show]]\nclaim = \"altitude(s, 9) > 0\"\n");
  EXPECT_TRUE(error_of().starts_with("asks-too-much (k=1, m=2): ")) << error_of();
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
