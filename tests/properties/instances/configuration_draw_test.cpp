#include "properties/instances/configuration_draw.hpp"

#include <gtest/gtest.h>

#include "kernel/simplex/edges.hpp"
#include "kernel/simplex/thickness.hpp"
#include "properties/instances/configuration_geometry.hpp"
#include "tests/properties/instances/drawn_configurations.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using namespace drawn_configurations;

TEST(ConfigurationDraw, ForbiddenConfigurationsMeetTheHypothesesOfTheLemmaAndHaveItsProperties) {
  bool tiny = false;
  bool at_limit = false;
  for (const Shape& shape : shapes) {
    const auto all = drawn(draw_forbidden_configuration, LimitsOfTheLemma(), shape, draws);
    EXPECT_GE(all.size() * 5, draws * 4U) << shape.k << " " << shape.m;
    for (const Configuration& c : all) {
      EXPECT_EQ(c.points.size(), static_cast<std::size_t>(shape.k) + 2);
      EXPECT_EQ(c.points.front().size(), static_cast<std::size_t>(shape.m));
      EXPECT_LE(c.mu0, Rational(1));
      EXPECT_LE(c.rho0, c.mu0 / Rational(4));
      EXPECT_LE(c.gamma0, Rational(2) * square(c.mu0) / Rational(75));
      EXPECT_LE(c.delta0, power(c.gamma0, shape.m + 1));
      EXPECT_LE(c.perturbed_epsilon, (Rational(1) + c.rho0) * c.epsilon);
      EXPECT_GE(c.perturbed_mu0 * c.perturbed_epsilon, (c.mu0 - Rational(2) * c.rho0) * c.epsilon);
      EXPECT_TRUE(is_forbidden_configuration(c));
      EXPECT_TRUE(has_forbidden_properties(c));
      tiny = tiny || c.gamma0 < Rational::power_of_two(-100);
      at_limit = at_limit || c.gamma0 == Rational(2) * square(c.mu0) / Rational(75);
    }
  }
  EXPECT_TRUE(tiny);
  EXPECT_TRUE(at_limit);
}

TEST(ConfigurationDraw, SomeFacetsAreSliversThatAreHardlyGood) {
  int slivers = 0;
  for (const Configuration& c : drawn(draw_forbidden_configuration, LimitsOfTheLemma(), {3, 3}, draws)) {
    const auto simplex = edge_gram_from_points(c.points);
    for (std::size_t p = 0; p < c.points.size(); ++p) {
      const auto squared = squared_thickness(simplex.opposite_facet(p));
      ASSERT_TRUE(squared);
      EXPECT_GE(*squared, power(c.gamma0, 6));
      if (*squared <= power(c.gamma0, 6) * Rational(2)) ++slivers;
    }
  }
  EXPECT_GT(slivers, 5);
}

TEST(ConfigurationDraw, BelowTheDimensionOfTheSpaceSomeStandOutOfTheirPlane) {
  int standing = 0;
  for (const Configuration& c : drawn(draw_forbidden_configuration, LimitsOfTheLemma(), {2, 3}, draws)) {
    const auto squared = squared_thickness(edge_gram_from_points(c.points));
    ASSERT_TRUE(squared);
    EXPECT_LT(*squared, power(c.gamma0, 6));
    if (*squared >= power(c.gamma0, 6) / Rational(4)) ++standing;
  }
  EXPECT_GT(standing, 10);
}

TEST(ConfigurationDraw, WithoutALimitOfTheSeparationTheHexagonalNetComes) {
  int wide = 0;
  for (const Configuration& c : drawn(draw_forbidden_configuration, NoLimits(), {2, 2}, draws)) {
    EXPECT_TRUE(is_forbidden_configuration(c));
    if (c.mu0 <= Rational(1)) continue;
    ++wide;
    EXPECT_EQ(c.rho0, c.mu0 / Rational(4));
    EXPECT_GT(squared_longest_edge(edge_gram_from_points(c.points)), square(Rational(5) / Rational(2) * c.epsilon));
  }
  EXPECT_GT(wide, 3);
}

TEST(ConfigurationDraw, TheFourPropertiesHoldAndTheFirstHardly) {
  int hardly = 0;
  for (const Shape& shape : shapes) {
    const auto all = drawn(draw_forbidden_properties, LimitsOfTheLemma(), shape, draws);
    EXPECT_GE(all.size() * 5, draws * 4U) << shape.k << " " << shape.m;
    for (const Configuration& c : all) {
      EXPECT_TRUE(has_forbidden_properties(c));
      const Rational hoop = approximate_hoop(edge_gram_from_points(c.points));
      EXPECT_LE(hoop, c.hoop_bound());
      if (hoop >= c.hoop_bound() * Rational(7) / Rational(8)) ++hardly;
      Configuration tight = c;
      tight.mu0 *= Rational(2);
      if (hoop > tight.hoop_bound()) {
        EXPECT_FALSE(has_forbidden_properties(tight));
      }
    }
  }
  EXPECT_GT(hardly, 50);
}

TEST(ConfigurationDraw, TightOnesAttainTheHoopAndSomeTheRadius) {
  std::size_t attained = 0;
  for (const Shape& shape : {Shape{2, 2}, Shape{2, 3}, Shape{3, 3}}) {
    const auto configurations = drawn(draw_tight_properties, LimitsOfTheLemma(), shape, draws);
    for (const Configuration& configuration : configurations) {
      EXPECT_TRUE(has_forbidden_properties(configuration));
      // Smaller by 2⁻⁵⁹, the radius of the sphere or the hoop is too small for it.
      Configuration smaller = configuration;
      smaller.epsilon *= Rational(1) - Rational::power_of_two(-59);
      Configuration narrower = configuration;
      narrower.gamma0 *= Rational(1) - Rational::power_of_two(-59);
      EXPECT_FALSE(has_forbidden_properties(narrower));
      attained += has_forbidden_properties(smaller) ? 0U : 1U;
    }
  }
  EXPECT_GT(attained, draws / 10);
}

TEST(ConfigurationDraw, TrianglesAndTooHighDimensionsAreNotDrawn) {
  for (const Shape& shape : {Shape{1, 2}, Shape{3, 2}}) {
    EXPECT_TRUE(drawn(draw_forbidden_configuration, NoLimits(), shape, 3).empty());
    EXPECT_TRUE(drawn(draw_forbidden_properties, NoLimits(), shape, 3).empty());
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
