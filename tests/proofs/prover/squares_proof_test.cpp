#include "proofs/prover/squares_proof.hpp"

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::outcome;

const std::string three = "forall = { a = '[0, infinity)', b = '[0, infinity)', c = '[0, infinity)' }\n";
const std::string four =
    "forall = { a = '[0, infinity)', b = '[0, infinity)', c = '[0, infinity)', d = '[0, infinity)' }\n";

TEST(SquaresProof, means_of_three_and_four_numbers) {
  for (const std::string& lines :
       {three + "claim = '((a + b + c)/3)^3 >= a*b*c'", four + "claim = '((a + b + c + d)/4)^4 >= a*b*c*d'"}) {
    const StepOutcome found = outcome(lines);
    EXPECT_EQ(found.verdict, Verdict::proved) << lines;
    EXPECT_EQ(found.method, "squares") << lines;
  }
}

/// One per cent too strong, and refuted.
TEST(SquaresProof, means_that_are_too_strong_are_refuted) {
  EXPECT_EQ(outcome(three + "claim = '((a + b + c)/3)^3 >= 101/100*a*b*c'").verdict, Verdict::refuted);
  EXPECT_EQ(outcome(four + "claim = '((a + b + c + d)/4)^4 >= 101/100*a*b*c*d'").verdict, Verdict::refuted);
}

TEST(SquaresProof, uses_hypotheses) {
  const std::string plane = "forall = { x = '(-infinity, infinity)', y = '(-infinity, infinity)' }\n";
  // The least value of x² + y² on the line is 1/2, at an inner tie.
  const StepOutcome found = outcome(plane + "given = ['x + y >= 1']\nclaim = 'x^2 + y^2 >= 1/2'");
  EXPECT_EQ(found.verdict, Verdict::proved);
  EXPECT_EQ(found.method, "squares");
  EXPECT_EQ(outcome(plane + "given = ['x + y = 1']\nclaim = 'x^2 + y^2 >= 1/2'").verdict, Verdict::proved);
  EXPECT_EQ(outcome(plane + "given = ['x + y >= 1']\nclaim = 'x^2 + y^2 >= 501/1000'").verdict, Verdict::refuted);
  EXPECT_EQ(outcome(plane + "given = ['x + y <= 1']\nclaim = 'x^2 + y^2 >= 1/2'").verdict, Verdict::refuted);
  // A hypothesis that need not hold is no constraint.
  EXPECT_EQ(outcome(plane + "given = ['x + y >= 1 or x > 5']\nclaim = 'x^2 + y^2 >= 1/2'").verdict, Verdict::undecided);
}

TEST(SquaresProof, strict_ones_need_a_constant) {
  const std::string plane = "forall = { x = '(-infinity, infinity)', y = '(-infinity, infinity)' }\n";
  EXPECT_EQ(outcome(plane + "given = ['x + y >= 1']\nclaim = 'x^2 + y^2 > 1/2 - 1/2^30'").method, "squares");
  EXPECT_EQ(outcome(plane + "given = ['x + y >= 1']\nclaim = 'x^2 + y^2 > 1/2'").verdict, Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
