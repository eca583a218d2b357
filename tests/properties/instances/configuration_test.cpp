#include "properties/instances/configuration.hpp"

#include <gtest/gtest.h>

#include "tests/properties/instances/drawn_configurations.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using namespace drawn_configurations;

TEST(Configuration, BoundsAreThoseOfTheLemma) {
  Configuration c;
  c.gamma0 = Rational(1) / Rational(1024);
  c.delta0 = Rational(1) / Rational(8);
  c.mu0 = Rational(1) / Rational(2);
  c.epsilon = Rational(3);
  c.perturbed_mu0 = Rational(1) / Rational(4);
  c.perturbed_epsilon = Rational(5);
  EXPECT_EQ(c.protection(), Rational(5) / Rational(32));
  EXPECT_EQ(c.edge_bound(), Rational(5) / Rational(2) * Rational(33) / Rational(32) * Rational(3));
  EXPECT_EQ(c.hoop_bound(), Rational(64));
}

TEST(Configuration, SeparationIsTheLeastDistance) {
  EXPECT_EQ(squared_separation({{0, 0}, {5, 0}, {5, 2}}), Rational(4));
  EXPECT_EQ(squared_separation({{0, 0}, {5, 0}, {0, 0}}), Rational(0));
}

TEST(Configuration, WhatLacksOnePartOfTheDefinitionIsNotForbidden) {
  for (const Configuration& c : drawn(draw_forbidden_configuration, LimitsOfTheLemma(), {2, 2}, draws)) {
    Configuration apart = c;
    apart.perturbed_mu0 = Rational(3);
    EXPECT_FALSE(is_forbidden_configuration(apart));
    Configuration small = c;
    small.perturbed_epsilon = Rational::power_of_two(-10) * c.perturbed_epsilon;
    EXPECT_FALSE(is_forbidden_configuration(small));
    Configuration off = c;
    for (Rational& coordinate : off.points[0]) coordinate += Rational(1) / Rational(16);
    EXPECT_FALSE(is_forbidden_configuration(off));
    Configuration bad = c;
    bad.gamma0 = Rational(9) / Rational(10);
    EXPECT_FALSE(is_forbidden_configuration(bad));
  }
}

TEST(Configuration, ScalingKeepsAForbiddenConfiguration) {
  for (const Configuration& c : drawn(draw_forbidden_configuration, LimitsOfTheLemma(), {2, 3}, 5)) {
    const Configuration larger = scaled(c, Rational(7) / Rational(3));
    EXPECT_EQ(larger.epsilon, c.epsilon * Rational(7) / Rational(3));
    EXPECT_TRUE(is_forbidden_configuration(larger));
    EXPECT_TRUE(has_forbidden_properties(larger));
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
