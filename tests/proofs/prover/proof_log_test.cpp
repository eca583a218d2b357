#include "proofs/prover/proof_log.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::json;

Json line(const std::string& lines) {
  const Step of = test::step(lines);
  const StepOutcome outcome = prove(of);
  EXPECT_EQ(outcome.verdict, Verdict::proved);
  return Json::parse(proof_log_line("c", of, of.constants, outcome));
}

TEST(ProofLog, statements_are_s_expressions) {
  const Step of = test::step(
      "forall = { x = '[0, 1]' }\nlet = { a = '1 + x' }\nconstants = { c = '-1/2' }\n"
      "claim = 'not a < c or (x > 0 implies -sqrt(a)/2 <= max(x, 1, 2)^2 and x = x)'");
  EXPECT_EQ(s_expression(*expanded(of, of.claim.formula)),
            "(or (not (< (+ 1 x) (- (/ 1 2)))) (implies (> x 0) (and (<= (/ (- (sqrt (+ 1 x))) 2) (^ (max x 1 2) 2)) "
            "(= x x))))");
}

TEST(ProofLog, says_what_was_proved_and_how) {
  const Json json =
      line("forall = { xi = '(0, 1/4]' }\nconstants = { c = '4/5' }\ngiven = ['xi > 0']\nclaim = '1/(1 + xi) >= c'");
  EXPECT_EQ(json["claim"], "c");
  EXPECT_EQ(json["step"], "a");
  EXPECT_EQ(json["statement"], "(>= (/ 1 (+ 1 xi)) (/ 4 5))");
  EXPECT_EQ(json["hypotheses"], Json::array({"(> xi 0)"}));
  EXPECT_EQ(json["parameters"][0]["upper"], "1/4");
  EXPECT_EQ(json["parameters"][0]["has_lower"], false);
  ASSERT_EQ(json["goals"].size(), 1U);
  const Json& goal = json["goals"][0];
  EXPECT_EQ(goal["statement"], "(implies (> xi 0) (>= (/ 1 (+ 1 xi)) (/ 4 5)))");
  EXPECT_EQ(goal["trees"], Json::array({"leaf"}));
  EXPECT_EQ(goal["atoms"].size(), 2U);
}

TEST(ProofLog, carries_the_text_of_the_claim_on_one_line) {
  const std::string head = proof_log_head("c", "folder/c.toml", "name = 'c'\n");
  EXPECT_EQ(head.find('\n'), head.size() - 1);
  const Json json = Json::parse(head);
  EXPECT_EQ(json["version"], 2);
  EXPECT_EQ(json["file"], "folder/c.toml");
  EXPECT_EQ(json["text"], "name = 'c'\n");
  // printf "name = 'c'\n" | sha256sum
  EXPECT_EQ(json["sha256"], "937b52be88f6233d2b5de2457c4493912812e9603a7679e0c9549bcb292f21be");
}

TEST(ProofLog, has_the_tree_of_boxes) {
  const Json json = line("forall = { k = 'integer [1, infinity)' }\nclaim = '(k - 1)*(k - 2)*(k + log2(k)) >= 0'");
  const Json tree = json["goals"][0]["trees"][0];
  ASSERT_EQ(tree.size(), 5U);
  EXPECT_EQ(tree[0], "k");
  EXPECT_EQ(tree[1], "2");
  EXPECT_EQ(tree[2], "3");
  EXPECT_EQ(json["parameters"][0]["upper"], nullptr);
  EXPECT_EQ(json["goals"][0]["atoms"][0]["by"], "enclosure");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
