#include "proofs/tables/constant_table.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational fraction(long a, long b) { return Rational(a) / Rational(b); }

Claim claim() {
  Claim result;
  result.name = "lemma";
  Conclusion conclusion;
  conclusion.name = "bound";
  conclusion.text = "a <= 4*b";
  conclusion.twin = Statement{"bound-twin", "a <= 33/10*b", nullptr};
  result.conclusions.push_back(conclusion);
  Step step;
  step.name = "last";
  step.constants["c"] = Rational(4);
  result.steps.push_back(step);
  step.name = "other";
  result.steps.push_back(step);
  return result;
}

ConstantRow row() {
  ConstantRow result;
  result.label = "lem:x";
  result.statement = "|a| ≤ c·b";
  result.latex = "a \\le c\\,b";
  result.claim = "lemma";
  result.conclusion = "bound";
  result.pattern = "a <= C*b";
  result.steps = {"lemma/last/c", "lemma/other/c"};
  return result;
}

StepSlacks slacks(const Rational& last, const Rational& other) {
  return {{"lemma/last/c", {Rational(4), last}}, {"lemma/other/c", {Rational(4), other}}};
}

ConstantEntry entry(const ConstantRow& one, const StepSlacks& all = {}) {
  return constant_entries({{one}, {}}, {claim()}, all).at(0);
}

std::string message_of(const ConstantRow& one) {
  try {
    (void)entry(one);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(ConstantTable, takes_its_columns_from_the_claim_its_twin_and_its_steps) {
  const ConstantEntry found = entry(row(), slacks(fraction(7, 2), fraction(18, 5)));
  EXPECT_EQ(found.paper, Rational(4));
  EXPECT_EQ(found.provable, fraction(18, 5));
  EXPECT_EQ(found.refuted, fraction(33, 10));
  EXPECT_EQ(found.witness, "lemma.bound-twin.json");
}

TEST(ConstantTable, takes_the_weakest_of_several_steps) {
  ConstantRow lower = row();
  lower.direction = Direction::larger;
  EXPECT_EQ(entry(lower, slacks(fraction(7, 2), fraction(18, 5))).provable, fraction(7, 2));
  EXPECT_FALSE(entry(row(), {{"lemma/last/c", {Rational(4), Rational(3)}}}).provable);
  EXPECT_FALSE(entry(row()).provable);
  StepSlacks unproved = slacks(Rational(3), Rational(3));
  unproved["lemma/other/c"].proved.reset();
  EXPECT_FALSE(entry(row(), unproved).provable);
}

TEST(ConstantTable, takes_the_paper_s_constant_of_steps_alone_or_inverted) {
  ConstantRow of_step = row();
  of_step.claim = "";
  of_step.is_inverse_in_steps = true;
  const ConstantEntry found = entry(of_step, slacks(Rational(5), Rational(8)));
  EXPECT_EQ(found.paper, fraction(1, 4));
  EXPECT_EQ(found.provable, fraction(1, 5));
  EXPECT_FALSE(found.refuted);
}

TEST(ConstantTable, takes_hypotheses_where_no_conclusion_has_the_name) {
  Claim both = claim();
  Hypothesis hypothesis;
  hypothesis.name = "bound";
  hypothesis.text = "x <= 7*b";
  both.hypotheses.push_back(hypothesis);
  hypothesis.name = "small";
  hypothesis.text = "x <= (y/4)^2";
  both.hypotheses.push_back(hypothesis);
  ConstantRow small = row();
  small.steps.clear();
  EXPECT_EQ(constant_entries({{small}, {}}, {both}, {}).at(0).paper, Rational(4));
  small.conclusion = "small";
  small.pattern = "x <= (C*y)^2";
  EXPECT_EQ(constant_entries({{small}, {}}, {both}, {}).at(0).paper, fraction(1, 4));
}

TEST(ConstantTable, refuses_rows_that_do_not_fit) {
  ConstantRow wrong = row();
  wrong.pattern = "a <= C*b^2";
  EXPECT_EQ(message_of(wrong), "constant of lem:x, |a| ≤ c·b: the pattern does not fit lemma / bound");
  wrong = row();
  wrong.claim = "lema";
  EXPECT_TRUE(mentions(message_of(wrong), "there is no lema"));
  wrong = row();
  wrong.steps = {"lemma/last/d"};
  EXPECT_TRUE(mentions(message_of(wrong), "there is no lemma/last/d"));
  wrong = row();
  wrong.is_inverse_in_steps = true;
  EXPECT_TRUE(mentions(message_of(wrong), "a step states 1/4, not 4"));
}

TEST(ConstantTable, refuses_the_slack_of_another_version_of_a_step) {
  StepSlacks stale = slacks(Rational(3), Rational(3));
  stale["lemma/other/c"].stated = Rational(5);
  EXPECT_THROW((void)entry(row(), stale), InputError);
}

TEST(ConstantTable, is_printed_with_safe_roundings) {
  const std::string text = constant_table_markdown(
      {entry(row(), slacks(Rational(10) / Rational(300007), Rational(100003) / Rational(30000)))},
      {{"lem:y", "no constant"}});
  EXPECT_TRUE(mentions(text, "| lem:x | \\|a\\| ≤ c·b | 4 | 3.3335 | > 33/10 | – | – | lemma.bound-twin.json |\n"))
      << text;
  EXPECT_TRUE(mentions(text, "| lem:y | no constant |\n"));
  EXPECT_TRUE(mentions(constant_table_markdown({entry(row())}, {}), "| 4 | – | > 33/10 |"));
  const std::string latex = constant_table_latex({entry(row())});
  EXPECT_TRUE(mentions(latex,
                       "{\\raggedright lem:\\allowbreak{}x\\par} & {\\raggedright $a \\le c\\,b$\\par} & "
                       "{\\raggedright $4$\\par} & {\\raggedright --\\par} & {\\raggedright $> 33/10$\\par} & "
                       "{\\raggedright --\\par} \\\\\n"))
      << latex;
}

TEST(ConstantTable, has_the_worst_ratio_of_its_conclusion_rounded_downwards) {
  const auto with = [](const WorstRatio& ratio) {
    return constant_table_markdown(
        {constant_entries({{row()}, {}}, {claim()}, {}, {{"lemma/bound", {{"k=1", ratio}}}}).at(0)}, {});
  };
  EXPECT_TRUE(mentions(with({fraction(2, 3), false}), "| > 33/10 | k=1: 0.66666 | – | lemma.bound"));
  EXPECT_TRUE(mentions(with({fraction(999999, 1000000), true}), "| > 33/10 | k=1: 1 | – | lemma.bound"));
  EXPECT_FALSE(constant_entries({{row()}, {}}, {claim()}, {}, {{"lemma/other", {{"k=1", {Rational(1), true}}}}})
                   .at(0)
                   .worst.contains("k=1"));
}

TEST(ConstantTable, has_the_power_of_the_term_with_the_constant_for_each_dimension) {
  const std::vector<PowerOfPlace> powers = {{"lemma", "bound", "k=1", "4*b", "bound", fraction(1, 2), false},
                                            {"lemma", "bound", "k=1", "4*b", "bound", fraction(2, 3), false},
                                            {"lemma", "bound", "k=2", "4*b", "bound", std::nullopt, false},
                                            {"lemma", "bound", "k=3", "b", "factor", std::nullopt, true}};
  EXPECT_EQ(constant_entries({{row()}, {}}, {claim()}, {}, {}, powers).at(0).power, "k=1: × 0.666, k=2: no power");
  EXPECT_EQ(constant_entries({{row()}, {}}, {claim()}, {}, {}, {powers[3]}).at(0).power, "");
}

TEST(ConstantTable, reads_what_the_prover_prints) {
  const std::string json = R"([{"claim": "a", "step": "s"},
    {"claim": "a", "step": "t", "slack": [{"constant": "c", "stated": "4", "proved": "7/2", "refuted": null},
                                          {"constant": "d", "stated": "1", "proved": null, "refuted": "2"}]}])";
  const StepSlacks read = parse_step_slacks(json, "f.json");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read.at("a/t/c").proved, fraction(7, 2));
  EXPECT_FALSE(read.at("a/t/d").proved);
  EXPECT_THROW((void)parse_step_slacks("{}", "f.json"), InputError);
  EXPECT_THROW((void)parse_step_slacks("[", "f.json"), InputError);
  EXPECT_THROW((void)parse_step_slacks(R"([{"claim": "a", "step": "t", "slack": [{"constant": "c"}]}])", "f.json"),
               InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
