#include "proofs/certificate/run_parameters.hpp"

#include <array>

#include "support/error.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

ParameterChoice choice_of(RunMode mode) {
  ParameterChoice choice;
  choice.mode = mode;
  return choice;
}

// docs/claims/theory-mode.md
constexpr std::array<long, 5> exponent_of_dimension{0, 30, 47, 72, 105};

TEST(ParametersFor, theory_mode_are_the_constants_of_the_paper) {
  const std::array<long, 5> tolerance_exponents{0, -15, -32, -57, -90};
  for (int m = 1; m <= 4; ++m) {
    const auto index = static_cast<std::size_t>(m);
    const auto parameters = parameters_for(Dimension(m), Rational(1), choice_of(RunMode::theory));
    EXPECT_EQ(parameters.mode, RunMode::theory);
    EXPECT_EQ(parameters.algorithm.separation, Rational(1));
    EXPECT_EQ(parameters.algorithm.perturbation, ratio(1, 4));
    EXPECT_EQ(parameters.algorithm.tolerance, Rational::power_of_two(tolerance_exponents[index]));
    EXPECT_EQ(parameters.squared_flake_parameter,
              Rational::power_of_two(-2 * exponent_of_dimension[index] - 4) / Rational(m * m * m));
    EXPECT_EQ(parameters.algorithm.circumradius_bound, Rational(2));
    EXPECT_EQ(parameters.algorithm.candidates, CandidateRule::pruned);
  }
}

/// The edge bound is an upper bound of (5/2)(1 + δ₀μ₀/2), δ₀² = (Γ₀²)^{m+1}, and exceeds it by next to nothing.
void expect_edge_bound(const RunParameters& parameters, int m) {
  const Rational& separation = parameters.algorithm.separation;
  const Rational excess = (parameters.algorithm.edge_bound / ratio(5, 2) - Rational(1)) * Rational(2) / separation;
  const Rational squared_protection = power(parameters.squared_flake_parameter, m + 1);
  EXPECT_GE(square(excess), squared_protection);
  const Rational less_excess = excess * (Rational(1) - Rational::power_of_two(-60)) - Rational::power_of_two(-120);
  EXPECT_TRUE(less_excess < Rational(0) || square(less_excess) < squared_protection);
}

TEST(ParametersFor, radii_that_vary_take_one_plus_the_variation) {
  for (int m = 1; m <= 4; ++m) {
    const auto uniform = parameters_for(Dimension(m), ratio(3, 4), choice_of(RunMode::theory));
    auto choice = choice_of(RunMode::theory);
    choice.perturbation = ratio(1, 8);
    const auto same = parameters_for(Dimension(m), ratio(3, 4), choice);
    const auto graded = parameters_for(Dimension(m), ratio(3, 4), choice, ratio(1, 8));
    EXPECT_EQ(graded.algorithm.radius_variation, ratio(1, 8));
    EXPECT_EQ(graded.algorithm.circumradius_bound, ratio(9, 4));
    EXPECT_EQ(graded.algorithm.edge_bound, same.algorithm.edge_bound * ratio(9, 8));
    // Γ₀ and the tolerance are made from ρ₀, not from ρ̃₀.
    EXPECT_EQ(graded.squared_flake_parameter, same.squared_flake_parameter);
    EXPECT_EQ(graded.algorithm.tolerance, same.algorithm.tolerance);
    const auto forbidden = graded.forbidden(ratio(1, 24));
    EXPECT_EQ(forbidden.sampling_radius, ratio(9, 8 * 24));
    EXPECT_EQ(forbidden.edge_bound, graded.algorithm.edge_bound / Rational(24));
    // By default ρ₀ is a little less than μ₀/(4(1 + ε₀)).
    const auto usual = parameters_for(Dimension(m), ratio(3, 4), choice_of(RunMode::theory), ratio(1, 8));
    EXPECT_LE(usual.algorithm.perturbation, ratio(1, 6));
    EXPECT_GE(usual.algorithm.perturbation, ratio(1, 6) * ratio(4095, 4096));
    EXPECT_EQ(uniform.algorithm.perturbation, ratio(3, 16));
    choice.perturbation = ratio(1, 6) + Rational::power_of_two(-60);
    EXPECT_TRUE(
        mentions(message_of<InputError>([&] { (void)parameters_for(Dimension(m), ratio(3, 4), choice, ratio(1, 8)); }),
                 "is not in (0, μ₀/(4(1 + ε₀))], μ₀ = 3/4, ε₀ = 1/8"));
    EXPECT_THROW((void)parameters_for(Dimension(m), ratio(3, 4), choice_of(RunMode::theory), ratio(9, 8)), InputError);
  }
}

TEST(ParametersFor, other_separations_follow_the_formulas) {
  for (int m = 1; m <= 4; ++m) {
    const long exponent = exponent_of_dimension[static_cast<std::size_t>(m)];
    for (const auto& separation : {Rational(1), ratio(1, 2), ratio(7, 9)}) {
      for (const auto& perturbation : {separation / Rational(4), separation / Rational(11)}) {
        auto choice = choice_of(RunMode::theory);
        choice.perturbation = perturbation;
        const auto parameters = parameters_for(Dimension(m), separation, choice);
        // 2α̃₀ = 2¹⁷ρ₀/(μ₀³(2/μ₀)^E); Γ₀ = ρ₀/(m^{3/2}(2/μ₀)^E).
        const Rational divisor = power(Rational(2) / separation, exponent);
        EXPECT_EQ(parameters.algorithm.tolerance,
                  Rational::power_of_two(17) * perturbation / (power(separation, 3) * divisor));
        EXPECT_EQ(parameters.squared_flake_parameter, square(perturbation / divisor) / Rational(m * m * m));
        EXPECT_EQ(parameters.algorithm.perturbation, perturbation);
        expect_edge_bound(parameters, m);
      }
    }
  }
}

TEST(ParametersFor, theory_mode_may_be_those_of_the_sharper_lemmas) {
  for (const int m : {1, 2, 3, 4}) {
    auto choice = choice_of(RunMode::theory);
    const auto printed = parameters_for(Dimension(m), Rational(1), choice);
    EXPECT_EQ(printed.constraints, ParameterConstraints::printed);
    choice.constraints = ParameterConstraints::sharper;
    const auto sharper = parameters_for(Dimension(m), Rational(1), choice);
    EXPECT_EQ(sharper.constraints, ParameterConstraints::sharper);
    // Γ₀ = 2^{−E−2} and 2α̃₀ = 34820Γ₀ for μ₀ = 1, ρ₀ = 1/4.
    const long exponent = 4L * m * m + 5L * m + 23;
    EXPECT_EQ(sharper.squared_flake_parameter, Rational::power_of_two(-2 * exponent)) << m;
    EXPECT_EQ(sharper.squared_flake_parameter, Rational(m * m * m) * printed.squared_flake_parameter) << m;
    EXPECT_EQ(sharper.algorithm.tolerance, Rational(34820) * Rational::power_of_two(-exponent)) << m;
    EXPECT_EQ(sharper.algorithm.tolerance, ratio(17410, 65536) * printed.algorithm.tolerance) << m;
  }
}

TEST(ParametersFor, measured_mode_have_no_choice_of_hypotheses) {
  auto choice = choice_of(RunMode::measured);
  choice.constraints = ParameterConstraints::printed;
  try {
    (void)parameters_for(Dimension(2), Rational(1), choice);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(mentions(error.what(), "the hypotheses can be chosen in theory mode only; mode is measured"));
  }
}

TEST(ParametersFor, measured_mode_have_the_flake_parameter_of_their_tolerance) {
  for (int m = 1; m <= 4; ++m) {
    auto choice = choice_of(RunMode::measured);
    choice.tolerance = ratio(1, 100);
    choice.seed = 77;
    choice.candidates = CandidateRule::whole;
    const auto parameters = parameters_for(Dimension(m), ratio(3, 4), choice);
    EXPECT_EQ(parameters.mode, RunMode::measured);
    EXPECT_EQ(parameters.algorithm.tolerance, ratio(1, 100));
    EXPECT_EQ(parameters.algorithm.perturbation, ratio(3, 16));
    EXPECT_EQ(parameters.algorithm.seed, 77U);
    EXPECT_EQ(parameters.algorithm.candidates, CandidateRule::whole);
    // 2α̃₀ = 2¹⁷m^{3/2}Γ₀/μ₀³, squared.
    EXPECT_EQ(square(parameters.algorithm.tolerance), Rational::power_of_two(34) * Rational(m * m * m) *
                                                          parameters.squared_flake_parameter / power(ratio(3, 4), 6));
    expect_edge_bound(parameters, m);
  }
}

TEST(ParametersFor, measured_mode_have_a_default_tolerance_for_each_dimension) {
  Rational before(1);
  for (int m = 1; m <= 4; ++m) {
    const auto parameters = parameters_for(Dimension(m), Rational(1), choice_of(RunMode::measured));
    EXPECT_EQ(parameters.algorithm.tolerance, default_tolerance(Dimension(m)));
    EXPECT_LT(default_tolerance(Dimension(m)), before) << "harder to have in higher dimensions";
    before = default_tolerance(Dimension(m));
  }
  EXPECT_THROW((void)default_tolerance(Dimension(5)), std::out_of_range);
}

TEST(ParametersFor, no_perturbation_is_one_by_0) {
  const auto parameters = parameters_for(Dimension(2), Rational(1), choice_of(RunMode::none));
  EXPECT_EQ(parameters.mode, RunMode::none);
  EXPECT_EQ(parameters.algorithm.perturbation, Rational(0));
  EXPECT_GT(parameters.squared_flake_parameter, Rational(0));
}

TEST(ParametersFor, clearance_and_choices_are_free_in_every_mode) {
  for (const auto mode : {RunMode::theory, RunMode::measured}) {
    auto choice = choice_of(mode);
    const auto usual = parameters_for(Dimension(2), Rational(1), choice);
    EXPECT_EQ(usual.algorithm.clearance, ratio(1, 20));
    EXPECT_EQ(usual.algorithm.choices, 20U);
    EXPECT_EQ(parameters_for(Dimension(3), Rational(1), choice).algorithm.choices, 100U);
    EXPECT_EQ(parameters_for(Dimension(4), Rational(1), choice).algorithm.clearance, Rational(0));
    EXPECT_EQ(parameters_for(Dimension(4), Rational(1), choice).algorithm.choices, 1U);
    choice.clearance = Rational(0);
    choice.choices = 1;
    const auto parameters = parameters_for(Dimension(2), Rational(1), choice);
    EXPECT_EQ(parameters.algorithm.clearance, Rational(0));
    EXPECT_EQ(parameters.algorithm.choices, 1U);
    EXPECT_EQ(parameters.algorithm.tolerance, usual.algorithm.tolerance);
    for (const Rational& wrong : {ratio(-1, 20), Rational(1)}) {
      choice.clearance = wrong;
      EXPECT_TRUE(mentions(message_of<InputError>([&] { (void)parameters_for(Dimension(2), Rational(1), choice); }),
                           "clearance "));
    }
    choice.clearance.reset();
    choice.choices = 0;
    EXPECT_TRUE(
        mentions(message_of<InputError>([&] { (void)parameters_for(Dimension(2), Rational(1), choice); }), "choices"));
  }
}

TEST(ParametersFor, refuse_what_is_out_of_range) {
  const auto refusal = [](RunMode mode, std::optional<Rational> perturbation, std::optional<Rational> tolerance,
                          const Rational& separation = ratio(1, 2)) {
    auto choice = choice_of(mode);
    choice.perturbation = std::move(perturbation);
    choice.tolerance = std::move(tolerance);
    return message_of<InputError>([&] { (void)parameters_for(Dimension(2), separation, choice); });
  };
  const std::optional<Rational> none;
  for (const auto mode : {RunMode::theory, RunMode::measured, RunMode::none}) {
    EXPECT_TRUE(mentions(refusal(mode, Rational(0), none), "perturbation 0 is not in (0, μ₀/4], μ₀ = 1/2"));
    EXPECT_TRUE(mentions(refusal(mode, ratio(-1, 9), none), "perturbation -1/9"));
    EXPECT_TRUE(mentions(refusal(mode, ratio(1, 8) + Rational::power_of_two(-300), none), "μ₀ = 1/2"));
  }
  EXPECT_TRUE(mentions(refusal(RunMode::theory, none, ratio(1, 100)), "measured mode only"));
  EXPECT_TRUE(mentions(refusal(RunMode::measured, none, Rational(0)), "tolerance 0 is not in (0, ρ₀), ρ₀ = 1/8"));
  EXPECT_TRUE(mentions(refusal(RunMode::measured, none, ratio(1, 8)), "tolerance 1/8"));
  EXPECT_TRUE(mentions(refusal(RunMode::measured, none, ratio(-1, 8)), "tolerance -1/8"));
  EXPECT_FALSE(refusal(RunMode::theory, none, none, Rational(2)).empty());
  EXPECT_FALSE(refusal(RunMode::theory, ratio(1, 8), none, Rational(0)).empty());
}

TEST(RunParameters, say_what_a_search_for_forbidden_configurations_looks_for) {
  const auto parameters = parameters_for(Dimension(2), ratio(1, 2), choice_of(RunMode::theory));
  const auto forbidden = parameters.forbidden(ratio(1, 24));
  EXPECT_EQ(forbidden.squared_flake_parameter, parameters.squared_flake_parameter);
  // α₀ = 2¹³Γ₀/μ₀³, and 2α₀ is no more than the tolerance.
  EXPECT_EQ(forbidden.squared_hoop_bound,
            square(Rational(1U << 13U)) * parameters.squared_flake_parameter / power(ratio(1, 2), 6));
  EXPECT_LE(Rational(4) * forbidden.squared_hoop_bound, square(parameters.algorithm.tolerance));
  EXPECT_EQ(forbidden.sampling_radius, ratio(1, 24));
  EXPECT_EQ(forbidden.edge_bound, parameters.algorithm.edge_bound / Rational(24));
}

TEST(RunParameters, modes_and_rules_have_the_names_of_files) {
  EXPECT_EQ(name_of(RunMode::theory), "theory");
  EXPECT_EQ(name_of(RunMode::measured), "measured");
  EXPECT_EQ(name_of(RunMode::none), "none");
  EXPECT_EQ(name_of(CandidateRule::pruned), "pruned");
  EXPECT_EQ(name_of(CandidateRule::whole), "whole");
  EXPECT_EQ(name_of(CandidateRule::printed), "printed");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
