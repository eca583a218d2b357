// Logs that the prover writes are accepted, and with one thing changed rejected.

#include "proofs/replay/replay.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "proofs/prover/proof_log.hpp"
#include "proofs/replay/number.hpp"
#include "tests/proofs/replay/replayed_step.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;
using test::logged;
using test::replayed;

std::string changed(Json step, const std::function<void(Json&)>& change) {
  EXPECT_EQ(replayed(step), "accepted");
  change(step);
  return replayed(step);
}

const char* const polynomial = "forall = { xi = '(0, 1/4]' }\nclaim = '1/(1 + xi) >= 4/5 and xi^2 < xi'";
const char* const cut = "forall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = '(x - y)^2 + x*y/10 + 1/100 > 0'";
const char* const integers = "forall = { k = 'integer [1, infinity)' }\nclaim = '(k - 1)*(k - 2)*(k + log2(k)) >= 0'";
const char* const squared = "forall = { m = 'integer [1, infinity)' }\nclaim = 'm^(3/2) >= m'";
const char* const enclosed = "forall = { x = '[3, 4]' }\nclaim = 'log2(x) > 158/100'";

TEST(Replay, accepts_what_the_prover_writes) {
  for (const char* lines :
       {polynomial, cut, integers, squared, enclosed,
        "forall = { m = 'integer [1, infinity)', mu0 = '(0, 1]' }\nclaim = 'constant_c(m, mu0) >= 2^30'",
        "forall = { x = '(-infinity, infinity)' }\nclaim = 'x^2 - x + 1 > 0'",
        "forall = { x = '[-1, 1]' }\nclaim = 'abs(x) <= 1 and max(x, -x) >= 0'",
        "forall = { k = 'integer [1, infinity)' }\nclaim = '2^k >= k + 1'",
        "forall = { m = 'integer [2, infinity)' }\nclaim = 'log2(m)/m <= 11/20'",
        "forall = { x = '[0, 1]', y = '[0, 1]' }\ngiven = ['x <= 1 - 2*y/3']\nclaim = 'x + y <= 3/2'",
        "forall = { x = '[0, 1]' }\nclaim = 'sqrt(1 + x) <= 3/2 and abs(x - 2) + x = 2'"}) {
    EXPECT_EQ(replayed(logged(lines)), "accepted") << lines;
  }
}

TEST(Replay, rejects_another_statement) {
  EXPECT_EQ(changed(logged(polynomial), [](Json& step) { step["statement"] = "(>= (/ 1 (+ 1 xi)) (/ 5 6))"; }),
            "c / a: as many goals as the statement has not");
  EXPECT_EQ(changed(logged(enclosed), [](Json& step) { step["statement"] = "(> (log2 x) 2)"; }),
            "c / a: goal 1: another statement");
  EXPECT_EQ(changed(logged(enclosed),
                    [](Json& step) { step["statement"] = step["goals"][0]["statement"] = "(> (log2 x) (/ 159 100))"; })
                .substr(0, 36),
            "c / a: goal 1: a leaf that is not pr");
  EXPECT_EQ(changed(logged(polynomial), [](Json& step) { step["hypotheses"].push_back("(> 0 1)"); }),
            "c / a: goal 1: another statement");
}

TEST(Replay, rejects_a_changed_coefficient) {
  const auto change = [](const char* factor) {
    return [factor](Json& step) {
      for (Json& known : step["goals"][0]["factors"]) {
        if (known != "xi + 1") known = factor;
      }
    };
  };
  EXPECT_EQ(changed(logged(polynomial), change("4*xi - 2")).substr(0, 48),
            "c / a: goal 1: a product that is not the differe");
  EXPECT_EQ(
      changed(logged(polynomial), [](Json& step) { step["goals"][0]["atoms"][0]["constant"] = "1/5"; }).substr(0, 48),
      "c / a: goal 1: a product that is not the differe");
  EXPECT_EQ(
      changed(logged(polynomial), [](Json& step) { step["goals"][0]["atoms"][0]["powers"][0][1] = 3; }).substr(0, 48),
      "c / a: goal 1: a product that is not the differe");
}

TEST(Replay, rejects_a_divisor_that_is_left_out) {
  EXPECT_EQ(changed(logged(polynomial), [](Json& step) { step["goals"][0]["atoms"][0]["divisors"] = Json::array(); }),
            "c / a: goal 1: a divisor that is not listed");
}

TEST(Replay, rejects_a_missing_leaf_goal_and_comparison) {
  EXPECT_EQ(changed(logged(cut), [](Json& step) { step["goals"][0]["trees"][0][4] = nullptr; }).substr(0, 25),
            "malformed: line 2: c / a:");
  EXPECT_EQ(changed(logged(cut), [](Json& step) { step["goals"][0]["trees"] = Json::array(); }),
            "c / a: goal 1: as many trees as the ranges have parts not");
  EXPECT_EQ(changed(logged(cut), [](Json& step) { step["goals"][0]["trees"][0] = "leaf"; }).substr(0, 42),
            "c / a: goal 1: a leaf that is not proved: ");
  EXPECT_EQ(changed(logged(polynomial), [](Json& step) { step["goals"].erase(1); }),
            "c / a: as many goals as the statement has not");
  EXPECT_EQ(changed(logged(polynomial), [](Json& step) { step["goals"][0]["atoms"].erase(0); }),
            "c / a: goal 1: as many comparisons as the statement has not");
}

TEST(Replay, rejects_boxes_that_do_not_cover) {
  EXPECT_EQ(changed(logged(integers), [](Json& step) { step["goals"][0]["trees"][0][2] = "4"; }),
            "c / a: goal 1: a cut that leaves out k between 2 and 4");
  EXPECT_EQ(changed(logged(cut), [](Json& step) { step["goals"][0]["trees"][0][1] = "1/3"; }).substr(0, 34),
            "c / a: goal 1: a cut that leaves o");
  EXPECT_EQ(
      changed(logged(cut), [](Json& step) { step["goals"][0]["trees"][0][1] = step["goals"][0]["trees"][0][2] = "2"; }),
      "c / a: goal 1: a cut outside of the box");
}

TEST(Replay, rejects_a_widened_box) {
  EXPECT_EQ(changed(logged(polynomial), [](Json& step) { step["parameters"][0]["upper"] = "1/2"; }).substr(0, 42),
            "c / a: goal 1: a leaf that is not proved: ");
  EXPECT_EQ(changed(logged(polynomial), [](Json& step) { step["parameters"][0]["has_lower"] = true; }).substr(0, 42),
            "c / a: goal 2: a leaf that is not proved: ");
  EXPECT_EQ(changed(logged(enclosed), [](Json& step) { step["parameters"][0]["lower"] = "2"; }).substr(0, 42),
            "c / a: goal 1: a leaf that is not proved: ");
  EXPECT_EQ(changed(logged(integers), [](Json& step) { step["parameters"][0]["integer"] = false; }).substr(0, 35),
            "c / a: goal 1: a cut that leaves ou");
}

TEST(Replay, rejects_a_wrong_substitution) {
  EXPECT_EQ(changed(logged(squared), [](Json& step) { step["goals"][0]["squared"] = Json::array(); }),
            "c / a: goal 1: a root of what is no square");
  EXPECT_EQ(changed(logged(polynomial), [](Json& step) { step["goals"][0]["squared"] = {"xi"}; }).substr(0, 48),
            "c / a: goal 1: a product that is not the differe");
  EXPECT_EQ(changed(logged(cut),
                    [](Json& step) {
                      step["parameters"][0]["lower"] = "-1";
                      step["goals"][0]["squared"] = {"x"};
                    }),
            "c / a: goal 1: a squared parameter that may be negative");
}

TEST(Replay, rejects_a_precision_that_does_not_suffice) {
  EXPECT_EQ(changed(logged(enclosed), [](Json& step) { step["goals"][0]["precision"] = 4; }).substr(0, 42),
            "c / a: goal 1: a leaf that is not proved: ");
  EXPECT_EQ(changed(logged(enclosed), [](Json& step) { step["goals"][0]["precision"] = 0; }),
            "c / a: goal 1: a precision that is not from 2 to 4096");
}

TEST(Replay, rejects_exact_leaves_that_are_no_points) {
  EXPECT_EQ(changed(logged(cut), [](Json& step) { step["goals"][0]["trees"][0] = "exact"; }),
            "c / a: goal 1: an exact leaf that is no point");
}

TEST(Replay, rejects_exponents_without_a_meaning) {
  EXPECT_EQ(changed(logged("forall = { k = 'integer [1, 5]' }\nclaim = '2^(k/2) > 1'"),
                    [](Json& step) { step["statement"] = step["goals"][0]["statement"] = "(> (^ 2 (/ k 3)) 1)"; }),
            "c / a: an exponent that need not be half an integer");
  EXPECT_EQ(changed(logged("forall = { k = 'integer [1, 5]' }\nclaim = '2^k > 1'"),
                    [](Json& step) { step["parameters"][0]["integer"] = false; }),
            "c / a: an exponent that is not made of integers");
}

TEST(Replay, refuses_what_is_no_log) {
  for (const char* text : {"", "{}\n", "{\"format\":\"delcert-proof-log\",\"version\":1}\n", "[1\n",
                           "{\"format\":\"delcert-proof-log\",\"version\":2}\n"}) {
    std::istringstream log(text);
    EXPECT_THROW((void)replay::replay_as_logged(log), replay::Malformed) << text;
  }
  const std::string head = proof_log_head("c", "c.toml", "name = 'c'");
  std::istringstream empty_step(head + "{}\n");
  EXPECT_THROW((void)replay::replay_as_logged(empty_step), replay::Malformed);
  std::istringstream no_toml(proof_log_head("c", "c.toml", "name = "));
  EXPECT_THROW((void)replay::replay_as_logged(no_toml), replay::Malformed);
}

std::string file_with(const std::string& lines) { return "name = 'c'\n[[step]]\nname = 'a'\n" + lines; }

/// "accepted", or why not and on which line, of a log of these lines against a file of the claim.
std::string held_to_file(const std::string& file, const std::string& head, const Json& step) {
  std::istringstream log(head + step.dump() + "\n");
  replay::StatedClaims claims;
  add_claim(claims, file, "c.toml");
  try {
    const replay::Totals totals = replay::replay(log, claims);
    EXPECT_TRUE(totals.claim == "c" && totals.proved.contains("a") && !totals.by_its_own_text);
    return "accepted";
  } catch (const replay::Rejected& rejected) {
    return std::to_string(rejected.line()) + ": " + rejected.what();
  }
}

/// The same of a log that carries the file's text.
std::string held_to(const std::string& lines, const Json& step) {
  return held_to_file(file_with(lines), proof_log_head("c", "c.toml", file_with(lines)), step);
}

// Each log is a right proof of something else than the file states: only the comparison with the file rejects it.
void expect_forgery_rejected(const std::string& stated, const std::string& forged, const std::string& why) {
  const Json log = logged(forged);
  EXPECT_EQ(replayed(log), "accepted") << forged;
  EXPECT_EQ(held_to(forged, log), "accepted") << forged;
  EXPECT_EQ(held_to(stated, log), "2: c / a: rule " + why + " (c.toml:2)") << forged;
}

TEST(ReplayedStatements, are_those_of_the_file) {
  for (const char* lines :
       {polynomial, cut, integers, squared, enclosed,
        "forall = { m = 'integer [1, infinity)', mu0 = '(0, 1]' }\nclaim = 'constant_c(m, mu0) >= 2^30'",
        "forall = { x = '[-1, 1]' }\nconstants = { c = '-3/4' }\nlet = { z = 'y + 1', y = 'x^2' }\n"
        "given = ['z <= 2', 'not (x > 1)']\nclaim = '-c*z > 0 and (x < 0 implies y >= 0)'"}) {
    EXPECT_EQ(held_to(lines, logged(lines)), "accepted") << lines;
  }
}

TEST(ReplayedStatements, are_not_replaced) {
  const std::string range = "forall = { x = '[0, 1]' }\n";
  expect_forgery_rejected(range + "claim = 'x*(1 - x) <= 1/4'", range + "claim = '0 <= 1'",
                          "statement: (<= 0 1), stated is (<= (* x (- 1 x)) (/ 1 4))");
  expect_forgery_rejected(range + "claim = 'x*(1 - x) <= 1/5'", range + "claim = 'x*(1 - x) <= 1/4'",
                          "statement: (<= (* x (- 1 x)) (/ 1 4)), stated is (<= (* x (- 1 x)) (/ 1 5))");
  expect_forgery_rejected(range + "constants = { c = '1/5' }\nclaim = 'x*(1 - x) <= c'",
                          range + "constants = { c = '1/4' }\nclaim = 'x*(1 - x) <= c'",
                          "statement: (<= (* x (- 1 x)) (/ 1 4)), stated is (<= (* x (- 1 x)) (/ 1 5))");
}

TEST(ReplayedStatements, have_the_ranges_of_the_file) {
  const std::string claim = "claim = 'x*(1 - x) < 1/4'";
  expect_forgery_rejected("forall = { x = '[0, 1]' }\n" + claim, "forall = { x = '[0, 1/3]' }\n" + claim,
                          "ranges: x in [0, 1/3], stated is [0, 1]");
  expect_forgery_rejected("forall = { x = '[0, 1/2]' }\n" + claim, "forall = { x = '[0, 1/2)' }\n" + claim,
                          "ranges: x in [0, 1/2), stated is [0, 1/2]");
  expect_forgery_rejected("forall = { x = '[0, 1]' }\n" + claim, "forall = { x = 'integer [0, 1]' }\n" + claim,
                          "ranges: x in integer [0, 1], stated is [0, 1]");
  expect_forgery_rejected("forall = { x = '(-infinity, 1/3]' }\n" + claim, "forall = { x = '[-9, 1/3]' }\n" + claim,
                          "ranges: x in [-9, 1/3], stated is (-infinity, 1/3]");
  expect_forgery_rejected("forall = { x = '[0, 1/3]', y = '[0, 1]' }\n" + claim,
                          "forall = { x = '[0, 1/3]' }\n" + claim, "ranges: a parameter that is stated is missing");
  expect_forgery_rejected("forall = { x = '[0, 1/3]' }\n" + claim,
                          "forall = { x = '[0, 1/3]', y = '[0, 1]' }\n" + claim,
                          "ranges: a parameter y that is not stated");
}

TEST(ReplayedStatements, have_the_hypotheses_of_the_file) {
  const std::string range = "forall = { x = '[0, 1]' }\n";
  const std::string claim = "claim = 'x*(1 - x) < 1/4'";
  expect_forgery_rejected(range + claim, range + "given = ['x < 1/3']\n" + claim, "hypotheses: 1, stated are 0");
  expect_forgery_rejected(range + "given = ['x <= 1/2']\n" + claim, range + "given = ['x < 1/3']\n" + claim,
                          "hypotheses: (< x (/ 1 3)), stated is (<= x (/ 1 2))");
}

TEST(ReplayedStatements, are_of_a_claim_and_a_step_that_are_known) {
  Json log = logged(polynomial);
  log["step"] = "b";
  EXPECT_EQ(held_to(polynomial, log), "2: c / b: rule step: c.toml has none of this name");
  log["claim"] = "d";
  EXPECT_EQ(held_to(polynomial, log), "2: d / b: rule claim: the log is one of c");
}

// Each step of these logs is as the file states it, and proved.
TEST(ReplayedStatements, come_with_the_text_of_the_file) {
  const std::string file = file_with(cut);
  const Json step = logged(cut);
  const std::string head = proof_log_head("c", "c.toml", file);
  EXPECT_EQ(held_to_file(file, head, step), "accepted");
  EXPECT_EQ(held_to_file(file + "\n# changed", head, step).substr(0, 70),
            "1: rule text: c.toml has changed since the log was written: its SHA-25");
  Json forged = Json::parse(head);
  forged["text"] = file + "\n# changed";
  EXPECT_EQ(held_to_file(file, forged.dump() + "\n", step).substr(0, 44),
            "1: rule hash: the text in the log has SHA-25");
  EXPECT_EQ(held_to_file(file, proof_log_head("d", "c.toml", file), step),
            "1: rule claim: the text in the log is not that of d");
  EXPECT_EQ(held_to_file("name = 'd'", head, step), "1: rule claim: no claim c is known; --claims names its file");
}

TEST(ReplayedStatements, of_a_claim_without_a_file_are_those_of_the_text_in_the_log) {
  const auto alone = [](const std::string& lines, const Json& step) -> std::string {
    std::istringstream log(proof_log_head("c", "there/c.toml", file_with(lines)) + step.dump() + "\n");
    try {
      const replay::Totals totals = replay::replay(log, {}, replay::UnknownClaim::by_the_log);
      EXPECT_TRUE(totals.by_its_own_text && totals.file == "there/c.toml");
      return "accepted";
    } catch (const replay::Rejected& rejected) {
      return rejected.what();
    }
  };
  EXPECT_EQ(alone(cut, logged(cut)), "accepted");
  EXPECT_EQ(
      alone("forall = { x = '[0, 1]' }\nclaim = 'x*(1 - x) <= 1/5'",
            logged("forall = { x = '[0, 1]' }\nclaim = 'x*(1 - x) <= 1'")),
      "c / a: rule statement: (<= (* x (- 1 x)) 1), stated is (<= (* x (- 1 x)) (/ 1 5)) (the text in the log:2)");
}

TEST(ReplayedStatements, of_a_claim_as_stated_need_a_proof_all_the_same) {
  Json log = logged(cut);
  log["goals"][0]["trees"][0] = "leaf";
  EXPECT_EQ(held_to(cut, log).substr(0, 45), "2: c / a: goal 1: a leaf that is not proved: ");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
