#include "proofs/constants/ledger.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational fraction(long numerator, long denominator) { return Rational(numerator) / Rational(denominator); }

Ledger surface() { return constants_for(Dimension{2}, Rational(1), fraction(1, 4)); }

std::string message_of(Dimension dimension, const Rational& separation, const Rational& perturbation,
                       const Rational& radius_variation = Rational(0), const Rational& distortion = Rational(0)) {
  try {
    (void)constants_for(dimension, separation, perturbation, radius_variation, distortion);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// One row of the table of constants measured in trials: rounded logarithms of C, Γ₀, 2α̃₀, δ₀, ξ₀'s bound.
struct TrialRow {
  int dimension;
  Rational separation;
  Rational perturbation;
  Rational flake_divisor, flake_parameter, tolerance, protection_parameter, distortion_bound;
};

bool near(const PowerProduct& x, const Rational& logarithm, const Rational& rounding) {
  const Bounds log2 = x.log2();
  return absolute(log2.lower - logarithm) <= rounding && absolute(log2.upper - logarithm) <= rounding;
}

TEST(Ledger, reproduces_the_constants_of_the_trials) {
  const TrialRow rows[] = {{2, Rational(1), fraction(1, 4), fraction(97, 2), fraction(-101, 2), Rational(-32),
                            fraction(-303, 2), Rational(-509)},
                           {3, Rational(1), fraction(1, 4), fraction(744, 10), fraction(-764, 10), Rational(-57),
                            fraction(-3055, 10), Rational(-1073)},
                           {2, fraction(1, 2), fraction(1, 8), fraction(191, 2), fraction(-197, 2), Rational(-77),
                            fraction(-591, 2), Rational(-989)},
                           {3, fraction(1, 2), fraction(1, 8), fraction(1464, 10), fraction(-1494, 10), Rational(-127),
                            fraction(-5975, 10), Rational(-2095)}};
  const Rational tenth = fraction(1, 10);
  const Rational half = fraction(1, 2);
  for (const TrialRow& row : rows) {
    const Ledger ledger = constants_for(Dimension{row.dimension}, row.separation, row.perturbation);
    EXPECT_TRUE(near(ledger.flake_divisor, row.flake_divisor, tenth));
    EXPECT_TRUE(near(ledger.flake_parameter, row.flake_parameter, tenth));
    EXPECT_TRUE(near(ledger.tolerance, row.tolerance, half));
    EXPECT_TRUE(near(ledger.protection_parameter, row.protection_parameter, tenth));
    EXPECT_TRUE(near(ledger.distortion_bound, row.distortion_bound, Rational(1)));
    EXPECT_FALSE(near(ledger.flake_parameter, row.flake_parameter + Rational(1), tenth));
  }
}

TEST(Ledger, reproduces_the_sampling_radii_of_the_trials) {
  const Rational rounding(1);
  EXPECT_TRUE(near(surface().chart_sampling_radius, Rational(-258), rounding));
  EXPECT_TRUE(
      near(constants_for(Dimension{3}, Rational(1), fraction(1, 4)).chart_sampling_radius, Rational(-540), rounding));
  EXPECT_TRUE(near(constants_for(Dimension{2}, Rational(1), fraction(1, 5)).riemannian_sampling_radius, Rational(-280),
                   rounding));
  EXPECT_TRUE(near(constants_for(Dimension{3}, Rational(1), fraction(1, 5)).riemannian_sampling_radius, Rational(-606),
                   rounding));
}

TEST(Ledger, is_exact_for_a_surface) {
  const Ledger ledger = surface();
  EXPECT_EQ(ledger.flake_divisor.text(), "2^(97/2)");
  EXPECT_EQ(ledger.flake_parameter.text(), "2^(-101/2)");
  EXPECT_EQ(ledger.flake_parameter.squared(), Rational::power_of_two(-101));
  EXPECT_EQ(ledger.protection_parameter.squared(), Rational::power_of_two(-303));
  EXPECT_EQ(ledger.hoop_bound.squared(), Rational::power_of_two(-75));
  EXPECT_EQ(ledger.hoop_bound_tilde.rational(), Rational::power_of_two(-33));
  EXPECT_EQ(ledger.tolerance.rational(), Rational::power_of_two(-32));
  EXPECT_EQ(ledger.distortion_bound.rational(), Rational::power_of_two(-509));
  EXPECT_EQ(ledger.perturbed_separation, fraction(2, 5));
  EXPECT_EQ(ledger.perturbed_radius_ratio, fraction(5, 4));
  EXPECT_EQ(ledger.candidates_bound.rational(), power(Rational(14), 6));
  EXPECT_EQ(ledger.riemannian_perturbation, fraction(1, 5));
  EXPECT_EQ(ledger.radius_variation_bound, Rational(1));
}

TEST(Ledger, is_exact_in_dimension_three) {
  const Ledger ledger = constants_for(Dimension{3}, Rational(1), fraction(1, 4));
  EXPECT_EQ(ledger.flake_divisor.text(), "2^72·3^(3/2)");
  EXPECT_EQ(ledger.flake_parameter.text(), "2^(-74)·3^(-3/2)");
  EXPECT_EQ(ledger.protection_parameter.text(), "2^(-296)·3^(-6)");
  EXPECT_EQ(ledger.tolerance.text(), "2^(-57)");
  EXPECT_EQ(ledger.riemannian_flake_divisor.text(), "2^81·3^(3/2)");
}

TEST(Ledger, has_no_square_roots_on_a_curve) {
  const Ledger ledger = constants_for(Dimension{1}, Rational(1), fraction(1, 4));
  EXPECT_EQ(ledger.flake_divisor.rational(), Rational::power_of_two(30));
  EXPECT_EQ(ledger.protection_parameter.rational(), Rational::power_of_two(-64));
}

TEST(Ledger, bounds_the_longest_edge_of_a_forbidden_configuration_tightly) {
  for (int m = 1; m <= 4; ++m) {
    const Ledger ledger = constants_for(Dimension{m}, Rational(1), fraction(1, 4));
    // 2 · (2/5 · bound − 1)/μ₀ is what the bound takes δ₀ to be.
    const Rational delta = Rational(2) * (Rational(2) / Rational(5) * ledger.longest_edge_upper - Rational(1));
    EXPECT_GE(square(delta), ledger.protection_parameter.squared()) << m;
    EXPECT_LE(delta, ledger.protection_parameter.bounds().upper + Rational::power_of_two(-128)) << m;
  }
}

TEST(Ledger, says_when_the_distortion_is_too_large) {
  const Rational bound = surface().distortion_bound.rational();
  const auto with_distortion = [](const Rational& distortion) {
    return constants_for(Dimension{2}, Rational(1), fraction(1, 5), Rational(0), distortion);
  };
  const Rational bound_at_a_fifth = with_distortion(Rational(0)).distortion_bound.rational();
  EXPECT_LT(bound_at_a_fifth, bound);
  EXPECT_TRUE(satisfies_parameter_constraints(with_distortion(Rational(0))));
  EXPECT_TRUE(satisfies_parameter_constraints(with_distortion(bound_at_a_fifth)));
  EXPECT_FALSE(satisfies_parameter_constraints(
      with_distortion(bound_at_a_fifth * (Rational(1) + Rational::power_of_two(-400)))));
}

TEST(Ledger, of_the_sharper_lemmas_admits_more_distortion) {
  for (const int m : {1, 2, 3, 5}) {
    const Ledger printed = constants_for(Dimension{m}, fraction(1, 2), fraction(1, 9));
    const Ledger sharper = constants_for(Dimension{m}, fraction(1, 2), fraction(1, 9), Rational(0), Rational(0),
                                         ParameterConstraints::sharper);
    EXPECT_EQ(sharper.flake_divisor.rational(), power(Rational(4), 4 * m * m + 5 * m + 21)) << m;
    EXPECT_EQ(sharper.distortion_bound.rational(), sharper.hoop_distortion_bound.rational()) << m;
    EXPECT_EQ(sharper.distortion_bound.rational(),
              (power(sharper.flake_parameter, 2 * m + 2) / power(PowerProduct(Rational(2)), 4)).rational())
        << m;
    EXPECT_LT(printed.distortion_bound, sharper.distortion_bound) << m;
    // What the other lemmas ask for.
    EXPECT_LT(sharper.distortion_bound, sharper.stable_stars_distortion_bound) << m;
    EXPECT_LT(sharper.distortion_bound, sharper.metric_distortion_bound) << m;
    EXPECT_LT(sharper.tolerance, printed.tolerance) << m;
    EXPECT_LE(sharper.flake_parameter, PowerProduct(sharper.flake_parameter_bound)) << m;
    // Even for the greatest variation of radii, ε₀ = 1, α̃₀ is above that of an isometry, (1 + ε₀)α₀.
    EXPECT_LT(sharper.hoop_bound * PowerProduct(Rational(2)), sharper.hoop_bound_tilde) << m;
  }
}

// docs/claims/riemannian-constants.md
TEST(Ledger, of_the_sharper_lemmas_asks_less_of_a_manifold) {
  for (const int m : {2, 3}) {
    const Ledger printed = constants_for(Dimension{m}, Rational(1), fraction(1, 4));
    const Ledger sharper = constants_for(Dimension{m}, Rational(1), fraction(1, 4), Rational(0), Rational(0),
                                         ParameterConstraints::sharper);
    const PowerProduct two(Rational(2));
    EXPECT_EQ(sharper.riemannian_flake_divisor, sharper.flake_divisor);
    EXPECT_EQ(sharper.riemannian_flake_parameter.rational(),
              Rational::power_of_two(-(4 * m * m + 5 * m + 21)) / Rational(5));
    EXPECT_EQ(sharper.riemannian_sampling_radius, power(sharper.riemannian_flake_parameter, m + 1) / power(two, 5));
    EXPECT_EQ(sharper.self_delaunay_sampling_radius,
              power(sharper.riemannian_flake_parameter, 2 * m + 1) / power(two, 5));
    EXPECT_EQ(printed.self_delaunay_sampling_radius, printed.riemannian_sampling_radius);
    EXPECT_LT(printed.riemannian_sampling_radius, sharper.self_delaunay_sampling_radius);
    EXPECT_LT(sharper.self_delaunay_sampling_radius, sharper.riemannian_sampling_radius);
    // 320/2¹⁰ Γ²
    EXPECT_EQ(sharper.piecewise_flat_distortion,
              PowerProduct(fraction(5, 16)) * power(sharper.riemannian_flake_parameter, 2));
  }
}

TEST(Ledger, of_the_sharper_lemmas_is_exact_for_a_surface) {
  const auto with_distortion = [](const Rational& distortion) {
    return constants_for(Dimension{2}, Rational(1), fraction(1, 5), Rational(0), distortion,
                         ParameterConstraints::sharper);
  };
  const Ledger sharper =
      constants_for(Dimension{2}, Rational(1), fraction(1, 4), Rational(0), Rational(0), ParameterConstraints::sharper);
  EXPECT_EQ(sharper.flake_parameter.rational(), Rational::power_of_two(-49));
  EXPECT_EQ(sharper.distortion_bound.rational(), Rational::power_of_two(-298));
  EXPECT_EQ(sharper.tolerance.rational(), Rational(34820) * Rational::power_of_two(-49));
  const Rational bound = with_distortion(Rational(0)).distortion_bound.rational();
  EXPECT_TRUE(satisfies_parameter_constraints(with_distortion(bound)));
  EXPECT_FALSE(satisfies_parameter_constraints(with_distortion(bound * (Rational(1) + Rational::power_of_two(-400)))));
}

TEST(Ledger, refuses_a_dimension_out_of_range) {
  EXPECT_TRUE(mentions(message_of(Dimension{0}, Rational(1), fraction(1, 4)), "dimension is 0; allowed: 1 to 16"));
  EXPECT_TRUE(mentions(message_of(Dimension{17}, Rational(1), fraction(1, 4)), "dimension is 17"));
  EXPECT_EQ(message_of(Dimension{16}, Rational(1), fraction(1, 4)), "");
}

TEST(Ledger, refuses_a_separation_out_of_range_and_advises) {
  const std::string message = message_of(Dimension{2}, fraction(3, 2), fraction(1, 4));
  EXPECT_TRUE(mentions(message, "separation is 3/2; allowed: above 0 and at most 1")) << message;
  EXPECT_TRUE(mentions(message, "min(1, measured)")) << message;
  EXPECT_TRUE(mentions(message_of(Dimension{2}, Rational(0), fraction(1, 4)), "separation is 0"));
}

TEST(Ledger, refuses_a_perturbation_out_of_range) {
  EXPECT_EQ(message_of(Dimension{2}, fraction(1, 2), fraction(1, 8)), "");
  EXPECT_TRUE(mentions(message_of(Dimension{2}, fraction(1, 2), fraction(1, 7)),
                       "perturbation is 1/7; allowed: above 0 and at most 1/8"));
  EXPECT_TRUE(mentions(message_of(Dimension{2}, Rational(1), Rational(0)), "perturbation is 0"));
  EXPECT_TRUE(mentions(message_of(Dimension{2}, Rational(1), fraction(1, 4), fraction(1, 4)), "at most 1/5"));
}

TEST(Ledger, refuses_a_radius_variation_or_distortion_out_of_range) {
  EXPECT_TRUE(mentions(message_of(Dimension{2}, Rational(1), fraction(1, 10), fraction(2, 3), fraction(1, 3)),
                       "radius variation is 2/3; allowed: 0 to (1 - distortion)/(1 + distortion) = 1/2"));
  EXPECT_EQ(message_of(Dimension{2}, Rational(1), fraction(1, 10), fraction(1, 2), fraction(1, 3)), "");
  EXPECT_TRUE(mentions(message_of(Dimension{2}, Rational(1), fraction(1, 10), Rational(-1)), "radius variation is -1"));
  EXPECT_TRUE(mentions(message_of(Dimension{2}, Rational(1), fraction(1, 10), Rational(0), Rational(1)),
                       "distortion is 1; allowed: at least 0 and below 1"));
  EXPECT_TRUE(
      mentions(message_of(Dimension{2}, Rational(1), fraction(1, 10), Rational(0), Rational(-1)), "distortion is -1"));
}

/// The same formulas once more, in rational arithmetic throughout.
RC_GTEST_PROP(Ledger, agrees_with_the_formulas_expanded_in_rationals, ()) {
  const long m = *rc::gen::inRange<long>(1, 5);
  const auto denominator = *rc::gen::inRange<long>(1, 1000);
  const Rational mu = fraction(*rc::gen::inRange<long>(1, denominator + 1), denominator);
  const Rational rho = mu * fraction(*rc::gen::inRange<long>(1, 101), 400);
  const Ledger ledger = constants_for(Dimension{m}, mu, rho);

  const Rational divisor_squared = power(Rational(m), 3) * power(Rational(2) / mu, 2 * (4 * m * m + 5 * m + 21));
  const Rational flake_squared = rho * rho / divisor_squared;
  RC_ASSERT(ledger.flake_divisor.squared() == divisor_squared);
  RC_ASSERT(ledger.flake_parameter.squared() == flake_squared);
  RC_ASSERT(ledger.protection_parameter.squared() == power(flake_squared, m + 1));
  RC_ASSERT(ledger.hoop_bound.squared() == Rational::power_of_two(26) * flake_squared / power(mu, 6));
  RC_ASSERT(ledger.hoop_bound_tilde.squared() ==
            Rational::power_of_two(32) * power(Rational(m), 3) * flake_squared / power(mu, 6));
  RC_ASSERT(ledger.tolerance.rational() ==
            Rational::power_of_two(17) * rho * power(mu / Rational(2), 4 * m * m + 5 * m + 21) / power(mu, 3));
  RC_ASSERT(ledger.distortion_bound.rational() == power(flake_squared, 2 * m + 1) / Rational(16));
  RC_ASSERT(ledger.metric_distortion_bound.squared() ==
            power(flake_squared, 2 * m + 1) * power(mu, 4) / Rational::power_of_two(24));
  RC_ASSERT(ledger.chart_sampling_radius.squared() == power(flake_squared, 2 * m + 1) / Rational::power_of_two(12));
  RC_ASSERT(ledger.candidates_bound.rational() == power(Rational(14) / mu, m * m + m));
  RC_ASSERT(ledger.riemannian_flake_divisor.squared() == divisor_squared * power(Rational(2) / mu, 2 * m * m));
  const Rational riemannian = minimum(rho, mu / Rational(5));
  RC_ASSERT(ledger.riemannian_flake_parameter.squared() ==
            riemannian * riemannian / ledger.riemannian_flake_divisor.squared());
  RC_ASSERT(ledger.riemannian_sampling_radius.squared() ==
            power(ledger.riemannian_flake_parameter.squared(), 2 * m + 1) / Rational::power_of_two(12));
}

/// What the paper says about its constants without computing them.
RC_GTEST_PROP(Ledger, satisfies_what_the_paper_claims_of_it, ()) {
  const long m = *rc::gen::inRange<long>(1, 6);
  const auto denominator = *rc::gen::inRange<long>(1, 1000);
  const Rational mu = fraction(*rc::gen::inRange<long>(1, denominator + 1), denominator);
  const Rational rho = mu * fraction(*rc::gen::inRange<long>(1, 101), 400);
  const Ledger ledger = constants_for(Dimension{m}, mu, rho);
  const PowerProduct two_fifths(fraction(2, 5));

  // eq:dnobnd, and δ₀ ≤ 2/5 where the neighbourhoods of configurations are bounded.
  RC_ASSERT(ledger.flake_parameter <= PowerProduct(Rational(2) * mu * mu / Rational(75)));
  RC_ASSERT(ledger.protection_parameter == power(ledger.flake_parameter, m + 1));
  RC_ASSERT(ledger.protection_parameter <= two_fifths);
  // α̃₀ is 2³m^{3/2} times α₀.
  RC_ASSERT(ledger.hoop_bound_tilde ==
            ledger.hoop_bound * PowerProduct(Rational(8)) * PowerProduct::square_root_of(Rational(m * m * m)));
  // The bound of Hypotheses 2 is that of lem:hoop.distort, and implies those of lem:stable.stars and of Theorem 2.
  RC_ASSERT(ledger.distortion_bound == ledger.hoop_distortion_bound);
  RC_ASSERT(ledger.distortion_bound < ledger.stable_stars_distortion_bound);
  RC_ASSERT(ledger.distortion_bound < ledger.metric_distortion_bound);
  // 6³Λε² meets it when ε is at most the chart sampling radius, and would not at twice that radius.
  const PowerProduct distortion = PowerProduct(Rational(216)) * power(ledger.chart_sampling_radius, 2);
  RC_ASSERT(distortion <= ledger.distortion_bound);
  RC_ASSERT(distortion * PowerProduct(Rational(4)) > ledger.distortion_bound);
  // Theorem 3 asks for more than its charts do.
  RC_ASSERT(ledger.riemannian_sampling_radius < ledger.chart_sampling_radius);
  // ε′ ≤ (5/4)ε and μ₀′ ≥ (2/5)μ₀.
  RC_ASSERT(ledger.perturbed_radius_ratio <= fraction(5, 4));
  RC_ASSERT(ledger.perturbed_separation >= fraction(2, 5) * mu);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
