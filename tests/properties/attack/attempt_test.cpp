#include "properties/attack/attempt.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::claim_about_simplices;
using test::triangle_bindings;
using test::wrong_claim;

const Rational half = Rational(1) / Rational(2);

TEST(Attempt, a_conclusion_holds_is_violated_and_its_ratio_encloses_the_exact_one) {
  // The right triangle (0, 0), (1, 0), (0, 1) has circumradius √2/2 and longest edge √2.
  const Attempt held = attempt(wrong_claim(), triangle_bindings(0, 1));
  EXPECT_EQ(held.hypotheses, Verdict::proved);
  ASSERT_EQ(held.conclusions.size(), 1U);
  EXPECT_EQ(held.conclusions[0].verdict, Verdict::proved);
  EXPECT_LE(held.conclusions[0].ratio->lower, 0.5);
  EXPECT_GE(held.conclusions[0].ratio->upper, 0.5);
  EXPECT_LE(held.conclusions[0].ratio->upper - held.conclusions[0].ratio->lower, 0x1p-20);
  const Attempt violated = attempt(wrong_claim(), triangle_bindings(half, Rational(1) / Rational(100)));
  EXPECT_EQ(violated.conclusions.at(0).verdict, Verdict::refuted);
  EXPECT_GT(violated.conclusions[0].ratio->lower, 1);
}

TEST(Attempt, where_a_hypothesis_fails_nothing_is_said_of_the_conclusions) {
  const Claim claim = claim_about_simplices("a", "given = [\"k <= 1\"]\n[[show]]\nclaim = \"k <= 1\"\n");
  const Attempt result = attempt(claim, triangle_bindings(0, 1));
  EXPECT_EQ(result.hypotheses, Verdict::refuted);
  EXPECT_TRUE(result.conclusions.empty());
}

TEST(Attempt, a_vertex_that_the_simplex_has_not_is_an_input_error) {
  const Claim claim = claim_about_simplices("a", "[[show]]\nclaim = \"altitude(s, 7) > 0\"\n");
  EXPECT_THROW((void)attempt(claim, triangle_bindings(0, 1)), InputError);
}

/// For the apex (1/2, h), R = (1/4 + h²)/(2h) and Υ = h/2 if h is small.
TEST(Attempt, leaves_out_a_ratio_that_is_exactly_known_not_to_be_above_another) {
  const Claim claim =
      claim_about_simplices("a", "[[show]]\nclaim = \"circumradius(s)*thickness(s) <= longest_edge(s)\"\n");
  const Bindings bindings = triangle_bindings(half, Rational::power_of_two(-80));
  const auto outcome = [&](double known) { return attempt(claim, bindings, std::array{known}).conclusions.at(0); };
  const ConclusionOutcome sharp = attempt(claim, bindings).conclusions.at(0);
  constexpr double sixteenth = 0x1p-4;
  ASSERT_TRUE(sharp.ratio);
  EXPECT_LE(sharp.ratio->lower, sixteenth);
  EXPECT_GT(sharp.ratio->upper, sixteenth);
  EXPECT_EQ(outcome(std::nextafter(sixteenth, 1)).verdict, Verdict::proved);
  EXPECT_FALSE(outcome(std::nextafter(sixteenth, 1)).ratio);
  // It is above 1/16, by 2⁻¹⁶².
  for (const double known : {sixteenth, -std::numeric_limits<double>::infinity()}) {
    ASSERT_TRUE(outcome(known).ratio) << known;
    EXPECT_EQ(outcome(known).ratio->lower, sharp.ratio->lower);
    EXPECT_EQ(outcome(known).ratio->upper, sharp.ratio->upper);
  }
}

/// Surds know the first of two comparisons only, and one that holds is enough to decide.
TEST(Attempt, leaves_out_no_ratio_of_several_comparisons) {
  const Claim claim = claim_about_simplices("a",
                                            "[[show]]\nclaim = \"circumradius(s)*thickness(s) <= longest_edge(s) or "
                                            "smallest_singular_value(s) <= longest_edge(s)/10\"\n");
  const Bindings bindings = triangle_bindings(half, Rational::power_of_two(-80));
  EXPECT_TRUE(attempt(claim, bindings, std::array{0.5}).conclusions.at(0).ratio);
}

TEST(AttemptedRatio, is_that_of_the_attempt_where_it_is_above_what_is_known) {
  const Claim claim = test::wrong_claim();
  const Bindings bindings = test::triangle_bindings(Rational(1) / Rational(2), Rational(1) / Rational(5));
  const auto sharp = attempt(claim, bindings).conclusions.at(0).ratio.value();
  for (const double known : {-1.0, 0.5}) {
    const auto ratio = attempted_ratio(claim, 0, bindings, known);
    ASSERT_TRUE(ratio.has_value());
    EXPECT_EQ(ratio->lower, sharp.lower);
    EXPECT_EQ(ratio->upper, sharp.upper);
  }
  EXPECT_LE(attempted_ratio(claim, 0, bindings, 10).value().upper, 10);
}

TEST(AttemptedRatio, is_nothing_where_a_hypothesis_fails_or_no_ratio_is_defined) {
  const Claim never = test::claim_about_simplices("a", "given = [\"k = 1\"]\n[[show]]\nclaim = \"k <= 1\"\n");
  EXPECT_FALSE(attempted_ratio(never, 0, test::triangle_bindings(0, 1), -1).has_value());
  const Claim no_ratio = test::claim_about_simplices("a", "[[show]]\nclaim = \"is_nondegenerate(s)\"\n");
  EXPECT_FALSE(attempted_ratio(no_ratio, 0, test::triangle_bindings(0, 1), -1).has_value());
}

TEST(AttemptedRatio, is_that_of_the_excess_over_the_base) {
  // 2R² = 1 and Δ² = 2 for this right triangle: (1 − 1/2)/(2 − 1/2) = 1/3 instead of 1/2.
  const std::string show = "[[show]]\nclaim = \"2*circumradius(s)^2 <= longest_edge(s)^2\"\n";
  const Claim plain = test::claim_about_simplices("a", show);
  const Claim excess = test::claim_about_simplices("a", show + "base = \"k/4\"\n");
  const Bindings bindings = test::triangle_bindings(Rational(0), Rational(1));
  EXPECT_DOUBLE_EQ(attempted_ratio(plain, 0, bindings, -1).value().lower, 0.5);
  const auto ratio = attempted_ratio(excess, 0, bindings, -1).value();
  EXPECT_LE(ratio.lower, 1.0 / 3);
  EXPECT_GE(ratio.upper, 1.0 / 3);
  EXPECT_LT(ratio.upper, 0.34);
  // What is decided stays the same.
  EXPECT_EQ(attempt(excess, bindings).conclusions.at(0).verdict, attempt(plain, bindings).conclusions.at(0).verdict);
  EXPECT_EQ(attempt(excess, bindings).conclusions.at(0).ratio->lower,
            attempt(plain, bindings).conclusions.at(0).ratio->lower);
}

TEST(AttemptedRatio, a_base_is_a_number_about_the_names_of_the_class) {
  for (const char* base : {"k <= 1", "p", "1/4 +"}) {
    EXPECT_THROW(
        (void)test::claim_about_simplices("a", "[[show]]\nclaim = \"k <= 3\"\nbase = \"" + std::string(base) + "\"\n"),
        InputError)
        << base;
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
