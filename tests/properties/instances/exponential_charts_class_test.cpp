#include "properties/instances/exponential_charts_class.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "properties/instances/space_object.hpp"
#include "tests/properties/instances/class_checks.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

constexpr std::array claims{"exponential-chart-distances", "exponential-chart-distances-sharper",
                            "exponential-chart-transitions", "exponential-chart-transitions-sharper"};

std::optional<Instance> draw(const Claim& claim, const Shape& shape, std::uint32_t number) {
  RandomChoices choices(5, static_cast<std::uint32_t>(shape.m), number);
  return draw_instance(claim, HypothesisLimits(claim), shape, choices);
}

Bindings some_charts() {
  const Claim claim = find_claim(claims[0]);
  for (std::uint32_t number = 0;; ++number) {
    if (const auto instance = draw(claim, {0, 3}, number)) return instance->bindings;
  }
}

TEST(ExponentialChartsClass, DrawsAreInstancesOfBothCurvaturesAndFewAreDiscarded) {
  for (const char* name : claims) {
    const Claim claim = find_claim(name);
    std::map<std::string, int> manifolds;
    int met = 0;
    int at_boundary = 0;
    constexpr int count = 60;
    for (std::uint32_t number = 0; number < count; ++number) {
      const auto instance = draw(claim, exponential_charts_class().shapes()[number % 2], number);
      if (!instance) continue;
      EXPECT_NO_THROW(exponential_charts_class().require(instance->bindings));
      const Bindings back = test::read_back(instance->bindings, exponential_charts_class().signature());
      EXPECT_NO_THROW(exponential_charts_class().require(back));
      ++manifolds[exponential_charts_class().manifold(back)];
      met += is_proved(attempt(claim, back).hypotheses) ? 1 : 0;
      at_boundary += instance->traits.contains(Trait::boundary) ? 1 : 0;
    }
    EXPECT_GE(5 * met, 4 * count) << name;
    EXPECT_GE(at_boundary, 10) << name;
    EXPECT_GE(manifolds["sphere"], 10) << name;
    EXPECT_GE(manifolds["hyperbolic space"], 10) << name;
  }
}

TEST(ExponentialChartsClass, WhatIsNoInstanceIsRefused) {
  const Bindings good = some_charts();
  const auto refused = [&good](const std::string& name, const Binding& value) {
    Bindings bad = good;
    bad[name] = value;
    EXPECT_THROW(exponential_charts_class().require(bad), InputError) << name;
  };
  EXPECT_NO_THROW(exponential_charts_class().require(good));
  const auto& space = object_in<SpaceObject>(good, "x");
  const auto with_points = [&space](std::vector<ExactPoint> points) {
    return ObjectPointer(std::make_shared<SpaceObject>(Curvature::positive, space.unit(), std::move(points)));
  };
  EXPECT_NO_THROW([&] {
    Bindings other = good;
    other["x"] = with_points(space.points());
    exponential_charts_class().require(other);
  }());
  auto points = space.points();
  points.pop_back();
  refused("x", with_points(points));
  points = space.points();
  points[3] = points[2];
  refused("x", with_points(points));
  // The antipode of j has the coordinates −4a/|a|².
  points = space.points();
  points[2] = combined(ExactPoint(3, Rational(0)), Rational(-4) / pairing(points[1], points[1]), points[1]);
  refused("x", with_points(points));
  refused("m", 2L);
  refused("a", 3L);
  refused("lambda", number_in(good, "lambda") * (Rational(1) - Rational::power_of_two(-60)));
  refused("r", Rational(0));
  refused("s", Rational(-1));
}

TEST(ExponentialChartsClass, SimplerInstancesAreInstances) {
  test::check_simpler(exponential_charts_class(), some_charts());
}

/// The bounds with 1/5 are nearly attained, so attacks would see it if they were a little smaller.
TEST(ExponentialChartsClass, AttacksComeNearTheSharperBounds) {
  const Claim claim = find_claim("exponential-chart-distances-sharper");
  std::vector<double> worst(claim.conclusions.size(), 0);
  for (std::uint32_t number = 0; number < 60; ++number) {
    const auto instance = draw(claim, {0, 2}, number);
    if (!instance) continue;
    for (std::size_t at = 0; at < worst.size(); ++at) {
      const auto ratio = attempted_ratio(claim, at, instance->bindings, worst[at]);
      if (ratio) worst[at] = std::max(worst[at], ratio->lower);
    }
  }
  EXPECT_GT(worst.at(0), 0.93);
  EXPECT_GT(worst.at(1), 0.86);
  EXPECT_GT(worst.at(2), 0.86);
}

void expect_to_hold(const char* name) {
  static const auto by_name = [] {
    std::map<std::string, Claim> result;
    for (const char* each : claims) result.emplace(each, find_claim(each));
    return result;
  }();
  const Claim& claim = by_name.at(name);
  const auto instance = draw(claim, {0, *rc::gen::element(2, 3)}, *rc::gen::arbitrary<std::uint32_t>());
  RC_PRE(instance.has_value());
  const Attempt result = attempt(claim, instance->bindings);
  RC_PRE(is_proved(result.hypotheses));
  for (const ConclusionOutcome& outcome : result.conclusions) RC_ASSERT(is_proved(outcome.verdict));
}

RC_GTEST_PROP(ExponentialChartsClass, ChartsStretchAsRauchSays, ()) { expect_to_hold(claims[0]); }
RC_GTEST_PROP(ExponentialChartsClass, ChartsStretchByAFifthAtMost, ()) { expect_to_hold(claims[1]); }
RC_GTEST_PROP(ExponentialChartsClass, TransitionsDistortByTheirBound, ()) { expect_to_hold(claims[2]); }
RC_GTEST_PROP(ExponentialChartsClass, TransitionsDistortByTheSharperBound, ()) { expect_to_hold(claims[3]); }

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
