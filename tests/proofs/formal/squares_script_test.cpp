#include "proofs/formal/squares_script.hpp"

#include "proofs/formal/step_lemma.hpp"
#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

const std::string means =
    "forall = { a = '[0, infinity)', b = '[0, infinity)', c = '[0, infinity)' }\n"
    "claim = '((a + b + c)/3)^3 >= a*b*c'";

SquaresScript script_of(const std::string& lines) {
  const Step step = test::step(lines);
  const StepOutcome outcome = prove(step);
  EXPECT_EQ(outcome.verdict, Verdict::proved);
  const GoalOutcome& goal = outcome.goals.at(0);
  return squares_script(goal.goal, goal.squares.value(), formal_parameters(step)).value();
}

TEST(SquaresScript, replaces_a_factor_by_its_squares) {
  const SquaresScript script = script_of(means);
  ASSERT_EQ(script.signs.size(), 1U);
  const auto& [polynomial, sign] = *script.signs.begin();
  EXPECT_FALSE(sign.strict);
  EXPECT_TRUE(sign.script.starts_with("replace (")) << sign.script;
  EXPECT_TRUE(sign.script.ends_with(" by field; sum_of_squares.")) << sign.script;
  EXPECT_NE(sign.script.find(" ^ 2 * (a)"), std::string::npos) << sign.script;
  EXPECT_NE(script.facts.find("0 <= (a)) by lra."), std::string::npos) << script.facts;
}

TEST(SquaresScript, keeps_a_constant_where_the_sign_is_strict) {
  const SquaresScript script = script_of(
      "forall = { x = '(-infinity, infinity)', y = '(-infinity, infinity)' }\ngiven = ['x + y >= 1']\n"
      "claim = 'x^2 + y^2 > 1/2 - 1/2^30'");
  ASSERT_EQ(script.signs.size(), 1U);
  EXPECT_TRUE(script.signs.begin()->second.strict);
  EXPECT_NE(script.signs.begin()->second.script.find("apply Rplus_le_lt_0_compat"), std::string::npos);
}

TEST(SquaresScript, makes_a_step_a_certificate) {
  const Step step = test::step(means);
  const StepLemma lemma = step_lemma(step, step.constants, "name").value();
  EXPECT_EQ(lemma.method, StepLemma::Method::certificate) << lemma.file;
  EXPECT_NE(lemma.file.find("Ltac sum_of_squares :="), std::string::npos);
  EXPECT_EQ(lemma.file.find("nra"), std::string::npos);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
