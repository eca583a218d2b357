#include "properties/attack/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "properties/attack/attempt.hpp"
#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::claim_about_simplices;

/// R ≤ Δ/(2Υ) with a surplus power of the thickness: the worst ratio at thickness v is some multiple of v.
Claim claim_with_a_power_too_many() {
  return claim_about_simplices(
      "a", "[[show]]\nname = \"radius\"\nclaim = \"circumradius(s) <= longest_edge(s)/(2*thickness(s)^2)\"\n");
}

std::optional<LineFit> fit_along_thickness(const Claim& claim, std::uint64_t evaluations) {
  std::vector<std::pair<double, double>> logarithms;
  for (const long exponent : {3L, 5L, 7L, 9L}) {
    const auto point =
        worst_at({claim, 0, {2, 2}, "thickness(s)", Rational::power_of_two(-exponent), evaluations}, 1, no_progress());
    if (point) logarithms.emplace_back(std::log2(point->quantity.lower), std::log2(point->worst.ratio.lower));
  }
  return line_through(logarithms);
}

TEST(Growth, a_planted_power_too_many_comes_out) {
  // The circumradius of a thin triangle can be Δ/(4Υ)·const: R = abc/(4A), so the exponent that is needed is 1.
  const auto fit = fit_along_thickness(claim_with_a_power_too_many(), 1500);
  ASSERT_TRUE(fit.has_value());
  EXPECT_NEAR(fit->slope, 1, 0.1);
  const auto right = fit_along_thickness(
      claim_about_simplices("a", "[[show]]\nclaim = \"circumradius(s) <= longest_edge(s)/(2*thickness(s))\"\n"), 1500);
  ASSERT_TRUE(right.has_value());
  EXPECT_NEAR(right->slope, 0, 0.1);
}

TEST(Growth, what_is_found_has_nearly_the_value) {
  const GrowthTarget target{claim_with_a_power_too_many(), 0, {2, 3}, "thickness(s)", Rational(1) / Rational(10), 300};
  const auto found = worst_at(target, 1, no_progress());
  ASSERT_TRUE(found.has_value());
  EXPECT_GE(found->quantity.upper, 0.1);
  EXPECT_LE(found->quantity.lower, 0.1 * 9 / 8);
  EXPECT_LE(found->quantity.upper - found->quantity.lower, 1e-9);
  const Claim narrow = claim_about_simplices(
      "a", "given = [\"thickness(s) >= 1/10\", \"thickness(s) <= 9/80\"]\n[[show]]\nclaim = \"k >= 1\"\n");
  EXPECT_EQ(attempt(narrow, found->worst.bindings).hypotheses, Verdict::proved);
}

TEST(Growth, where_no_instance_has_the_value_nothing_is_found) {
  const GrowthTarget target{claim_with_a_power_too_many(), 0, {2, 2}, "thickness(s)", Rational(9) / Rational(10), 100};
  EXPECT_FALSE(worst_at(target, 1, no_progress()).has_value());
}

TEST(Growth, a_quantity_is_a_number_of_the_claim) {
  const Claim claim = claim_with_a_power_too_many();
  EXPECT_NO_THROW((void)quantity_in(claim, "thickness(s)^2/k"));
  for (const char* wrong : {"thicknes(s)", "xi", "k >= 1", "thickness(", ""}) {
    EXPECT_THROW((void)quantity_in(claim, wrong), InputError) << wrong;
  }
}

TEST(Growth, lines_are_fitted_with_their_residuals) {
  const auto exact = line_through({{0, 1}, {1, 3}, {2, 5}, {5, 11}});
  ASSERT_TRUE(exact.has_value());
  EXPECT_NEAR(exact->slope, 2, 1e-12);
  EXPECT_NEAR(exact->residual, 0, 1e-12);
  EXPECT_NEAR(exact->error, 0, 1e-12);
  // By hand: slope 1/2, residuals −1/6, 1/3, −1/6, and √(1/6)/√2.
  const auto rough = line_through({{-1, 0}, {0, 1}, {1, 1}});
  ASSERT_TRUE(rough.has_value());
  EXPECT_NEAR(rough->slope, 0.5, 1e-12);
  EXPECT_NEAR(rough->residual, 1.0 / 3, 1e-12);
  EXPECT_NEAR(rough->error, std::sqrt(1.0 / 12), 1e-12);
  EXPECT_FALSE(line_through({{0, 1}, {1, 3}}).has_value());
  EXPECT_FALSE(line_through({{1, 1}, {1, 3}, {1, 2}}).has_value());
}

TEST(Growth, exponents_in_bounds_are_read) {
  const auto exponent = [](const std::string& claim, const std::string& quantity) {
    const Claim about = claim_about_simplices("a", "[[show]]\nclaim = \"" + claim + "\"\n");
    return exponent_in_bound(about, 0, *quantity_in(about, quantity), {3, 3});
  };
  const auto above =
      exponent("has_circumcentre(s) and circumradius(s) <= longest_edge(s)/(2*thickness(s)^3)", "thickness(s)");
  ASSERT_TRUE(above.has_value());
  EXPECT_EQ(above->exponent, Rational(-3));
  EXPECT_TRUE(above->is_from_above);
  const auto below = exponent("circumradius(s) >= 2/5*thickness(s)^k", "thickness(s)");
  ASSERT_TRUE(below.has_value());
  EXPECT_EQ(below->exponent, Rational(3));
  EXPECT_FALSE(below->is_from_above);
  EXPECT_FALSE(exponent("circumradius(s) <= 1 + thickness(s)", "thickness(s)").has_value());
  EXPECT_EQ(exponent("circumradius(s) <= 2*longest_edge(s)", "thickness(s)")->exponent, Rational(0));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
