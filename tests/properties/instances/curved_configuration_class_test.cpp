#include "properties/instances/curved_configuration_class.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "properties/instances/configuration_map.hpp"
#include "properties/instances/space_object.hpp"
#include "tests/properties/instances/class_checks.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

constexpr std::array claims{"curved-hoop-distortion", "curved-raw-hoop-distortion"};

std::optional<Instance> draw(const Claim& claim, const Shape& shape, std::uint32_t number) {
  const HypothesisLimits limits(claim);
  RandomChoices choices(5, static_cast<std::uint32_t>(shape.k * 16 + shape.m), number);
  return curved_configuration_class().draw(shape, {}, limits, choices);
}

Bindings some_configuration() {
  const Claim claim = find_claim(claims[0]);
  for (std::uint32_t number = 0;; ++number) {
    if (const auto instance = draw(claim, {2, 3}, number)) return instance->bindings;
  }
}

TEST(CurvedConfigurationClass, DrawsAreInstancesOfBothCurvatures) {
  for (const char* name : claims) {
    const Claim claim = find_claim(name);
    std::map<std::string, int> manifolds;
    int drawn = 0;
    int met = 0;
    constexpr int count = 36;
    for (std::uint32_t number = 0; number < count; ++number) {
      const auto instance = draw(claim, curved_configuration_class().shapes()[number % 3], number);
      if (!instance) continue;
      ++drawn;
      EXPECT_NO_THROW(curved_configuration_class().require(instance->bindings));
      const Bindings back = test::read_back(instance->bindings, curved_configuration_class().signature());
      EXPECT_NO_THROW(curved_configuration_class().require(back));
      ++manifolds[curved_configuration_class().manifold(back)];
      met += is_proved(attempt(claim, back).hypotheses) ? 1 : 0;
    }
    EXPECT_GE(3 * drawn, 2 * count) << name;
    EXPECT_EQ(met, drawn) << name;
    EXPECT_GE(manifolds["sphere"], 6) << name;
    EXPECT_GE(manifolds["hyperbolic space"], 6) << name;
  }
}

TEST(CurvedConfigurationClass, StructuredDrawsAreInstances) {
  const HypothesisLimits limits(find_claim(claims[1]));
  int found = 0;
  for (std::uint32_t number = 0; number < 30; ++number) {
    RandomChoices choices(6, 35, number);
    const auto instance = curved_configuration_class().draw_structured({2, 2}, {}, limits, choices);
    if (!instance) continue;
    ++found;
    EXPECT_NO_THROW(curved_configuration_class().require(instance->bindings));
  }
  EXPECT_GT(found, 3);
}

TEST(CurvedConfigurationClass, WhatIsNotTheTransitionIsRefused) {
  const Bindings good = some_configuration();
  EXPECT_NO_THROW(curved_configuration_class().require(good));
  const auto refused = [&good](const std::string& name, const Binding& value) {
    Bindings bad = good;
    bad[name] = value;
    EXPECT_THROW(curved_configuration_class().require(bad), InputError) << name;
  };
  const auto& space = object_in<SpaceObject>(good, "x");
  const auto with = [&space](Curvature curvature, std::vector<ExactPoint> points) {
    return ObjectPointer(std::make_shared<SpaceObject>(curvature, space.unit(), std::move(points)));
  };
  const bool is_sphere = space.curvature() == Curvature::positive;
  refused("x", with(is_sphere ? Curvature::negative : Curvature::positive, space.points()));
  refused("x", with(space.curvature(), {space.points()[1], space.points()[0]}));
  refused("x", with(space.curvature(), {space.points()[0], space.points()[0]}));
  refused("x", with(space.curvature(), {space.points()[0]}));
  refused("x", with(space.curvature(), {{0, 0}, {space.points()[1][0], space.points()[1][1]}}));
  refused("xi", number_in(good, "xi") / Rational(2));
  refused("u", good.at("t"));
  Bindings without = good;
  without.erase("x");
  EXPECT_THROW(curved_configuration_class().require(without), InputError);
  // A map of the same distortion that is no transition.
  ConfigurationMap::Finite map = object_in<ConfigurationMap>(good, "f").finite();
  for (ExactPoint& image : map.images) image[0] += Rational(1);
  Bindings moved = good;
  const auto changed = std::make_shared<ConfigurationMap>(map);
  moved["f"] = ObjectPointer(changed);
  moved["u"] =
      ObjectPointer(std::make_shared<SimplexObject>(changed->image(object_in<SimplexObject>(good, "t").points())));
  EXPECT_THROW(curved_configuration_class().require(moved), InputError);
}

TEST(CurvedConfigurationClass, SimplerInstancesAreInstances) {
  test::check_simpler(curved_configuration_class(), some_configuration());
}

RC_GTEST_PROP(CurvedConfigurationClass, TheHoopIsHardlyDistorted, ()) {
  static const Claim claim = find_claim(claims[0]);
  const auto shape = curved_configuration_class().shapes()[*rc::gen::inRange<std::size_t>(0, 3)];
  const auto instance = draw(claim, shape, *rc::gen::arbitrary<std::uint32_t>());
  RC_PRE(instance.has_value());
  const Attempt result = attempt(claim, instance->bindings);
  RC_ASSERT(is_proved(result.hypotheses));
  for (const ConclusionOutcome& outcome : result.conclusions) RC_ASSERT(is_proved(outcome.verdict));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
