#include "proofs/formal/step_lemma.hpp"

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

StepLemma lemma(const std::string& lines) {
  const Step step = test::step(lines);
  return step_lemma(step, step.constants, "name").value();
}

bool has(const StepLemma& lemma, std::string_view text) { return lemma.file.find(text) != std::string::npos; }

TEST(StepLemma, the_statement_is_the_step) {
  const StepLemma found = lemma(
      "forall = { k = 'integer [1, infinity)', u = '(0, 1]' }\nlet = { v = 'u/2' }\ngiven = ['v <= k']\n"
      "constants = { c = '3/2' }\nclaim = 'v <= c*k'");
  EXPECT_EQ(found.method, StepLemma::Method::certificate);
  EXPECT_TRUE(has(found,
                  "Lemma name :\nforall k u : R,\n  1 <= k ->\n  0 < u -> u <= 1 ->\n  ((u / 2) <= k) ->\n"
                  "  ((u / 2) <= ((3 / 2) * k)).\nProof.\nintros k u k_lower u_lower u_upper given_1.\n"))
      << found.file;
  EXPECT_TRUE(found.file.ends_with("Qed.\n"));
  EXPECT_FALSE(has(found, "Admitted"));
}

TEST(StepLemma, parts) {
  EXPECT_TRUE(has(lemma("forall = { x = '[0, 1]' }\nclaim = 'x >= 0 and x <= 1'"), "split."));
  EXPECT_TRUE(has(lemma("forall = { x = '[0, 1]' }\nclaim = 'max(x, 1 - x) <= 1'"), "apply Rmax_lub."));
  EXPECT_TRUE(has(lemma("forall = { x = '[0, 1]' }\nclaim = 'x - 1 <= min(x, x^2)'"), "apply Rmin_glb."));
  EXPECT_TRUE(has(lemma("forall = { x = '[-1, 1]' }\nclaim = 'abs(x) <= 1'"), "apply abs_at_most."));
  EXPECT_TRUE(has(lemma("forall = { x = '[0, 1]' }\nclaim = 'x >= 0 implies x <= 1'"), "intros premise_1."));
}

TEST(StepLemma, enclosures_where_there_is_no_certificate) {
  const StepLemma found = lemma("forall = { x = '[1, 2]' }\nclaim = 'log2(x) <= 3/2'");
  EXPECT_EQ(found.method, StepLemma::Method::search);
  EXPECT_TRUE(has(found, "interval with (i_prec 60, i_bisect x)")) << found.file;
}

TEST(StepLemma, a_false_step_is_refuted_by_its_counterexample) {
  const StepLemma found = lemma("forall = { xi = '(0, 1/3]' }\nconstants = { c = '4/5' }\nclaim = '1/(1 + xi) >= c'");
  EXPECT_EQ(found.method, StepLemma::Method::refutation);
  EXPECT_TRUE(has(found, "Lemma name_refuted : ~ (forall xi : R,")) << found.file;
  EXPECT_TRUE(has(found, " ltac:(number) ltac:(number)).\nrefute H.")) << found.file;
  const Step step = test::step("forall = { xi = '(0, 1/3]' }\nconstants = { c = '4/5' }\nclaim = '1/(1 + xi) >= c'");
  EXPECT_EQ(step_lemma(step, {{"c", test::ratio(3, 4)}}, "name")->method, StepLemma::Method::certificate);
}

TEST(StepLemma, methods_have_names) {
  EXPECT_EQ(name_of(StepLemma::Method::certificate), "certificate");
  EXPECT_EQ(name_of(StepLemma::Method::search), "search");
  EXPECT_EQ(name_of(StepLemma::Method::refutation), "refutation");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
