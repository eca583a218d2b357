#include "properties/instances/configuration_draw.hpp"

#include <gtest/gtest.h>

#include "kernel/simplex/edges.hpp"
#include "kernel/simplex/thickness.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// The hypotheses of lem:prop.forbid.cfg and μ₀ ≤ 1.
class LimitsOfTheLemma : public Limits {
 public:
  std::optional<Rational> most(const std::string& name, const Bindings& bound, bool) const override {
    const auto number = [&bound](const std::string& of) { return std::get<Rational>(bound.at(of)); };
    if (name == "mu0") return Rational(1);
    if (name == "rho0") return number("mu0") / Rational(4);
    if (name == "gamma0") return Rational(2) * square(number("mu0")) / Rational(75);
    if (name == "delta0") return power(number("gamma0"), std::get<long>(bound.at("m")) + 1);
    return std::nullopt;
  }
};

const std::vector<Shape> shapes{{2, 2}, {2, 3}, {3, 3}, {3, 4}, {4, 4}};
constexpr std::uint32_t draws = 40;

template <class Draw>
std::vector<Configuration> drawn(const Draw& draw, const Limits& limits, const Shape& shape, std::uint32_t count) {
  const Bindings bound{{"k", static_cast<long>(shape.k)}, {"m", static_cast<long>(shape.m)}};
  std::vector<Configuration> result;
  for (std::uint32_t number = 0; number < count; ++number) {
    RandomChoices choices(1, static_cast<std::uint32_t>(shape.k * 16 + shape.m), number);
    if (auto configuration = draw(shape, bound, limits, choices)) result.push_back(std::move(*configuration));
  }
  return result;
}

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

TEST(ConfigurationDraw, WhatLacksOnePartOfTheDefinitionIsNotForbidden) {
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

TEST(ConfigurationDraw, ScalingKeepsAForbiddenConfiguration) {
  for (const Configuration& c : drawn(draw_forbidden_configuration, LimitsOfTheLemma(), {2, 3}, 5)) {
    const Configuration larger = scaled(c, Rational(7) / Rational(3));
    EXPECT_EQ(larger.epsilon, c.epsilon * Rational(7) / Rational(3));
    EXPECT_TRUE(is_forbidden_configuration(larger));
    EXPECT_TRUE(has_forbidden_properties(larger));
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
