#include "proofs/prover/vacuity.hpp"

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Vacuity vacuity(const std::string& lines) { return vacuity_of(test::step(lines)); }

TEST(Vacuity, of_a_step_without_hypotheses_there_is_none) {
  const Vacuity found = vacuity("forall = { x = '(0, 1]', k = 'integer [3, infinity)' }\nclaim = 'x <= k'");
  EXPECT_EQ(found.verdict, Verdict::refuted);
  EXPECT_TRUE(found.point.at("x") > Rational(0) && found.point.at("x") <= Rational(1));
  EXPECT_TRUE(found.point.at("k") >= Rational(3));
  EXPECT_EQ(vacuity("claim = '1 < 2'").verdict, Verdict::refuted);
}

TEST(Vacuity, a_point_obeys_the_hypotheses) {
  const Vacuity found = vacuity("forall = { x = '[0, 1]', y = '[0, 1]' }\ngiven = ['x + y >= 2']\nclaim = 'x = y'");
  EXPECT_EQ(found.verdict, Verdict::refuted);
  EXPECT_EQ(found.point.at("x"), Rational(1));
  EXPECT_EQ(found.point.at("y"), Rational(1));
}

TEST(Vacuity, of_hypotheses_that_contradict_each_other_or_the_ranges) {
  for (const char* lines : {"forall = { x = '[0, 1]' }\ngiven = ['x > 1']\nclaim = 'x = 7'",
                            "forall = { x = '[0, 1]' }\ngiven = ['x < 1/2', 'x > 1/2']\nclaim = 'x <= 2'",
                            "forall = { x = '(-infinity, infinity)' }\ngiven = ['x^2 < 0']\nclaim = 'x = 0'",
                            "forall = { k = 'integer [1, 5]' }\ngiven = ['2*k = 5']\nclaim = 'k = 0'",
                            "forall = { x = '[2, 3]' }\ngiven = ['log2(x) > 2']\nclaim = 'x = 0'"}) {
    EXPECT_EQ(prove(test::step(lines)).verdict, Verdict::proved) << lines;
    const Vacuity found = vacuity(lines);
    EXPECT_EQ(found.verdict, Verdict::proved) << lines;
    EXPECT_FALSE(found.premises.empty());
    EXPECT_TRUE(found.point.empty());
  }
}

TEST(Vacuity, of_an_implication_whose_premise_never_holds) {
  const char* const lines = "forall = { x = '[0, 1]' }\nclaim = 'x <= 1 and (x > 2 implies x = 7)'";
  const Vacuity found = vacuity(lines);
  EXPECT_EQ(found.verdict, Verdict::proved);
  EXPECT_EQ(found.premises, "x > 2");
  EXPECT_EQ(vacuity("forall = { x = '[0, 1]' }\nclaim = 'x <= 1 and (x > 1/2 implies x >= 1/2)'").verdict,
            Verdict::refuted);
}

TEST(Vacuity, is_undecided_where_neither_is_found) {
  // The only point that obeys it is irrational.
  const Vacuity found = vacuity("forall = { x = '[1, 2]' }\ngiven = ['x^2 = 2']\nclaim = 'x^2 = 2'");
  EXPECT_EQ(found.verdict, Verdict::undecided);
  EXPECT_EQ(found.premises, "x^2 = 2");
  // No cut meets 1/3, and on a box around it neither hypothesis is false as a whole.
  EXPECT_EQ(vacuity("forall = { x = '[0, 1]' }\ngiven = ['x < 1/3', 'x > 1/3']\nclaim = 'x <= 2'").verdict,
            Verdict::undecided);
}

TEST(Vacuity, takes_the_constants_and_abbreviations_of_the_step) {
  const char* const lines =
      "forall = { x = '[0, 1]' }\nconstants = { c = '2' }\nlet = { y = 'c*x' }\ngiven = ['y >= c + 1']\nclaim = 'x = "
      "5'";
  EXPECT_EQ(vacuity(lines).verdict, Verdict::proved);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
