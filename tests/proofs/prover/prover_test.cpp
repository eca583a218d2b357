#include "proofs/prover/prover.hpp"

#include <gtest/gtest.h>

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::outcome;
using test::ratio;
using test::step;
using test::verdict;

TEST(Prover, polynomials_on_boxes_are_decided) {
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'x*(1 - x) <= 1/4'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'x*(1 - x) <= 1/4 - 1/2^40'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'x*(1 - x) < 1/4'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'x*(1 - x) < 1/4 + 1/2^40'"), Verdict::proved);
}

TEST(Prover, a_tie_at_a_corner_is_decided_and_a_strict_one_by_the_ends) {
  EXPECT_EQ(verdict("forall = { xi = '(0, 1/4]' }\nclaim = '1/(1 + xi) >= 4/5'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { xi = '(0, 1/4]' }\nclaim = '1/(1 + xi) > 4/5'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { xi = '(0, 1/4)' }\nclaim = '1/(1 + xi) > 4/5'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '(0, 1]', y = '[0, 1]' }\nclaim = 'x + y > 0'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = 'x + y > 0'"), Verdict::refuted);
}

TEST(Prover, a_tie_inside_is_decided_by_a_sum_of_squares_where_both_sides_are_polynomials) {
  const StepOutcome found =
      outcome("forall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = '(3*x - 1)^2 + (3*y - 1)^2 >= 0'");
  EXPECT_EQ(found.verdict, Verdict::proved);
  EXPECT_EQ(found.method, "squares");
  EXPECT_TRUE(found.left.empty());
  const StepOutcome other =
      outcome("forall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = '9*x^2 - 6*x + 1 + (3*y - 1)^2 + log2(1) >= 0'");
  EXPECT_EQ(other.verdict, Verdict::undecided);
  EXPECT_FALSE(other.left.empty());
  EXPECT_EQ(verdict("forall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = '(3*x - y)^2 >= 0'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = '(3*x - 1)^2 + (3*y - 1)^2 > 0'"),
            Verdict::refuted);
}

TEST(Prover, a_counterexample_is_an_exact_point_of_the_range) {
  const StepOutcome found = outcome("forall = { x = '(0, 1)', k = 'integer [2, infinity)' }\nclaim = 'k*x <= 1000'");
  ASSERT_EQ(found.verdict, Verdict::refuted);
  const Rational x = found.counterexample.at("x");
  const Rational k = found.counterexample.at("k");
  EXPECT_TRUE(x > Rational(0) && x < Rational(1) && k.denominator() == 1 && k * x > Rational(1000));
}

TEST(Prover, hypotheses_are_used) {
  const std::string head = "forall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = 'x + y <= 3/2'\n";
  EXPECT_EQ(verdict(head), Verdict::refuted);
  EXPECT_EQ(verdict(head + "given = ['x <= 1 - 2*y/3']"), Verdict::proved);
  EXPECT_EQ(verdict(head + "given = ['x <= 1 - y/3']"), Verdict::refuted);
}

TEST(Prover, ranges_without_end_and_integers) {
  EXPECT_EQ(verdict("forall = { k = 'integer [1, infinity)' }\nclaim = '(k - 1)*(k - 2) >= 0'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { k = '[1, infinity)' }\nclaim = '(k - 1)*(k - 2) >= 0'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { k = 'integer [1, infinity)' }\nclaim = '(k - 1)*(k - 3) >= 0'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { x = '(-infinity, infinity)' }\nclaim = 'x^2 - x + 1 > 0'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '(-infinity, infinity)' }\nclaim = 'x^2 - 2*x + 1 > 0'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { x = '(-infinity, 2)' }\nclaim = 'x < 2'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '(-infinity, 2)' }\nclaim = 'x > -10^30'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { k = 'integer [3, 3]' }\nclaim = 'k = 3'"), Verdict::proved);
}

TEST(Prover, roots_of_parameters_are_polynomials_of_their_roots) {
  const StepOutcome found =
      outcome("forall = { k = 'integer [1, infinity)' }\nclaim = 'sqrt(k) <= k and k^(3/2) >= k'");
  EXPECT_EQ(found.verdict, Verdict::proved);
  EXPECT_EQ(found.method, "polynomial");
  EXPECT_EQ(verdict("forall = { m = '[1, infinity)', k = '[1, infinity)' }\nclaim = 'sqrt(m*k) <= (m + k)/2'"),
            Verdict::proved);
  EXPECT_EQ(verdict("forall = { k = 'integer [2, 7]' }\nclaim = 'sqrt(k) <= 53/20'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { k = 'integer [2, 7]' }\nclaim = 'sqrt(k) <= 66/25'"), Verdict::refuted);
}

TEST(Prover, what_is_no_polynomial_is_enclosed) {
  EXPECT_EQ(
      verdict("forall = { m = 'integer [1, infinity)', mu0 = '(0, 1]' }\nclaim = '(2/mu0)^(4*m^2 + 5*m + 21) >= 2^30'"),
      Verdict::proved);
  EXPECT_EQ(
      verdict("forall = { m = 'integer [1, infinity)', mu0 = '(0, 1]' }\nclaim = '(2/mu0)^(4*m^2 + 5*m + 21) > 2^30'"),
      Verdict::refuted);
  EXPECT_EQ(verdict("forall = { m = 'integer [1, infinity)', mu0 = '(0, 1]' }\nclaim = 'constant_c(m, mu0) >= 2^30'"),
            Verdict::proved);
  EXPECT_EQ(verdict("forall = { m = 'integer [2, infinity)' }\nclaim = 'log2(m)/m <= 11/20'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { m = 'integer [2, infinity)' }\nclaim = 'log2(m)/m <= 13/25'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'sqrt(1 + x) <= 1 + x/2'"), Verdict::proved);
}

TEST(Prover, a_tail_is_proved_by_monotonicity) {
  EXPECT_EQ(verdict("forall = { k = 'integer [1, infinity)' }\nclaim = '2^k >= k + 1'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { k = 'integer [1, infinity)' }\nclaim = '2^k > k + 1'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { k = 'integer [2, infinity)' }\nclaim = '2^k > k + 1'"), Verdict::proved);
}

TEST(Prover, a_term_without_value_keeps_a_step_from_being_proved) {
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'x/x = 1'"), Verdict::undecided);
  EXPECT_EQ(verdict("forall = { x = '(0, 1]' }\nclaim = 'x/x = 1'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'max(x, 1/x) >= 0'"), Verdict::undecided);
  EXPECT_EQ(verdict("forall = { k = 'integer [1, 5]' }\nclaim = '2^(k/3) > 0'"), Verdict::undecided);
  EXPECT_EQ(verdict("forall = { k = 'integer [1, 5]' }\nclaim = '2^(k/2) > 1'"), Verdict::proved);
}

TEST(Prover, extremes_and_absolute_values) {
  EXPECT_EQ(verdict("forall = { x = '[-1, 1]' }\nclaim = 'abs(x) <= 1 and max(x, -x) >= 0'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '[-1, 1]' }\nclaim = 'abs(x) < 1'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { x = '[-1, 1]' }\nclaim = 'min(x, 1/2) <= 1/2 and 1/2 <= max(x, 1/2)'"),
            Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'abs(x + 1) - x = 1'"), Verdict::proved);
}

TEST(Prover, connectives) {
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'x >= 1/3 or x <= 1/2'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'x >= 1/2 or x <= 1/3'"), Verdict::refuted);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'x > 1/2 implies x^2 > 1/8'"), Verdict::proved);
  EXPECT_EQ(verdict("forall = { x = '[0, 1]' }\nclaim = 'not x^2 > x'"), Verdict::proved);
  EXPECT_EQ(verdict("claim = '2^10 > 1000'"), Verdict::proved);
  EXPECT_EQ(verdict("claim = '2^10 < 1000'"), Verdict::refuted);
  EXPECT_EQ(verdict("claim = 'sqrt(2)*sqrt(3) = sqrt(6)'"), Verdict::proved);
}

TEST(Prover, constants_take_other_values) {
  const Step ratio_of_edges =
      step("forall = { xi = '(0, 1/4]' }\nconstants = { c = '4/5' }\nclaim = '1/(1 + xi) >= c'");
  EXPECT_EQ(prove(ratio_of_edges).verdict, Verdict::proved);
  EXPECT_EQ(prove(ratio_of_edges, {{"c", ratio(81, 100)}}).verdict, Verdict::refuted);
  EXPECT_EQ(prove(ratio_of_edges, {{"c", ratio(79, 100)}}).verdict, Verdict::proved);
  EXPECT_EQ(decide_at(ratio_of_edges, {{"c", ratio(81, 100)}}, {{"xi", ratio(1, 4)}}), Verdict::refuted);
  EXPECT_EQ(decide_at(ratio_of_edges, {{"c", ratio(81, 100)}}, {{"xi", ratio(1, 8)}}), Verdict::proved);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
