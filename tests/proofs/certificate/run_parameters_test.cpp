#include "proofs/certificate/run_parameters.hpp"

#include <gtest/gtest.h>

#include "kernel/error.hpp"

namespace delcert {
namespace {

Rational fraction(long numerator, long denominator) { return Rational(Integer(numerator), Integer(denominator)); }

TEST(RunParameters, TheoryModeHasThePapersConstants) {
  // m = 2, μ₀ = 1, ρ₀ = 1/4: C = 2^{3/2}·2^47, Γ₀² = 2^-101, 2α̃₀ = 2^-32.
  const RunParameters two = parameters_for(Dimension(2), Rational(1), {});
  EXPECT_EQ(two.algorithm.perturbation, fraction(1, 4));
  EXPECT_EQ(two.algorithm.tolerance, Rational::power_of_two(-32));
  EXPECT_EQ(two.squared_flake_parameter, Rational::power_of_two(-101));
  const RunParameters three = parameters_for(Dimension(3), Rational(1), {});
  EXPECT_EQ(three.algorithm.tolerance, Rational::power_of_two(-57));
  EXPECT_EQ(three.squared_flake_parameter * Rational(27), Rational::power_of_two(-148));
  EXPECT_EQ(two.algorithm.circumradius_bound, Rational(2));
}

TEST(RunParameters, TheEdgeBoundIsAboveTheRealOne) {
  for (int m = 1; m <= 4; ++m) {
    const RunParameters parameters = parameters_for(Dimension(m), fraction(1, 2), {});
    EXPECT_GT(parameters.algorithm.edge_bound, fraction(5, 2));
    EXPECT_LT(parameters.algorithm.edge_bound, fraction(5, 2) * (Rational(1) + Rational::power_of_two(-60)));
    // (edge/(5/2) − 1) ≥ δ₀μ₀/2, on squares.
    const Rational excess = parameters.algorithm.edge_bound * fraction(2, 5) - Rational(1);
    EXPECT_GE(square(excess), power(parameters.squared_flake_parameter, m + 1) * square(fraction(1, 4)));
  }
}

TEST(RunParameters, MeasuredModeTurnsTheToleranceIntoTheFlakeParameter) {
  ParameterChoice choice;
  choice.mode = RunMode::measured;
  choice.tolerance = fraction(1, 50);
  const Rational separation = fraction(3, 4);
  const RunParameters parameters = parameters_for(Dimension(3), separation, choice);
  // (2¹⁷m^{3/2}Γ₀/μ₀³)² = tolerance².
  EXPECT_EQ(Rational::power_of_two(34) * Rational(27) * parameters.squared_flake_parameter / power(separation, 6),
            square(fraction(1, 50)));
  EXPECT_EQ(parameters.algorithm.perturbation, fraction(3, 16));
}

TEST(RunParameters, TheHoopBoundOfTheSearchIsThePapers) {
  const RunParameters parameters = parameters_for(Dimension(2), fraction(1, 2), {});
  const auto forbidden = parameters.forbidden(fraction(1, 24));
  EXPECT_EQ(forbidden.squared_hoop_bound * power(fraction(1, 2), 6),
            Rational::power_of_two(26) * parameters.squared_flake_parameter);
  EXPECT_EQ(forbidden.edge_bound, parameters.algorithm.edge_bound * fraction(1, 24));
}

TEST(RunParameters, DefaultTolerancesShrinkWithTheDimension) {
  for (int m = 2; m <= 4; ++m) EXPECT_LT(default_tolerance(Dimension(m)), default_tolerance(Dimension(m - 1)));
}

TEST(RunParameters, RefusesWhatIsOutOfRange) {
  ParameterChoice choice;
  choice.tolerance = fraction(1, 64);
  EXPECT_THROW((void)parameters_for(Dimension(2), Rational(1), choice), InputError);
  choice.mode = RunMode::measured;
  choice.tolerance = fraction(1, 4);
  EXPECT_THROW((void)parameters_for(Dimension(2), Rational(1), choice), InputError);
  choice.tolerance = fraction(1, 5);
  EXPECT_NO_THROW((void)parameters_for(Dimension(2), Rational(1), choice));
  choice.perturbation = fraction(26, 100);
  EXPECT_THROW((void)parameters_for(Dimension(2), Rational(1), choice), InputError);
  choice.perturbation = Rational(0);
  EXPECT_THROW((void)parameters_for(Dimension(2), Rational(1), choice), InputError);
}

}  // namespace
}  // namespace delcert
