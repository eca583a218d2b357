#include "properties/instances/transported_configuration_class.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "properties/instances/configuration_map.hpp"
#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::optional<Instance> draw(const Claim& claim, const Shape& shape, std::uint32_t number) {
  const HypothesisLimits limits(claim);
  RandomChoices choices(5, static_cast<std::uint32_t>(shape.k * 16 + shape.m), number);
  return transported_configuration_class().draw(shape, {}, limits, choices);
}

const Claim& raw_claim() {
  static const Claim claim = find_claim("raw-hoop-distortion");
  return claim;
}
const Claim& hoop_claim() {
  static const Claim claim = find_claim("hoop-distortion");
  return claim;
}

Instance some_transported_configuration() {
  for (std::uint32_t number = 0;; ++number) {
    if (auto instance = draw(raw_claim(), {2, 3}, number)) return *instance;
  }
}

Rational number(const Bindings& bindings, const std::string& name) { return std::get<Rational>(bindings.at(name)); }

TEST(TransportedConfigurationClass, DrawsOfEveryShapeAreInstancesAndFewAreDiscarded) {
  std::set<Trait> traits;
  bool is_tiny = false;
  for (const Claim* claim : {&raw_claim(), &hoop_claim()}) {
    for (const Shape& shape : transported_configuration_class().shapes()) {
      constexpr std::uint32_t count = 20;
      std::uint32_t kept = 0;
      for (std::uint32_t i = 0; i < count; ++i) {
        const auto instance = draw(*claim, shape, i);
        if (!instance) continue;
        ++kept;
        traits.insert(instance->traits.begin(), instance->traits.end());
        EXPECT_NO_THROW(transported_configuration_class().require(instance->bindings));
        is_tiny = is_tiny || number(instance->bindings, "xi") < Rational::power_of_two(-400);
      }
      EXPECT_GE(kept * 5, count * 4);
    }
  }
  EXPECT_TRUE(is_tiny);
  EXPECT_EQ(traits, (std::set<Trait>{Trait::boundary, Trait::nearly_degenerate, Trait::cospherical}));
}

TEST(TransportedConfigurationClass, StructuredDrawsAreAtTheirBoundsAndInstances) {
  const HypothesisLimits limits(raw_claim());
  int found = 0;
  for (const Shape& shape : {Shape{2, 2}, Shape{2, 3}, Shape{3, 3}}) {
    for (std::uint32_t i = 0; i < 40; ++i) {
      RandomChoices choices(6, static_cast<std::uint32_t>(shape.k * 16 + shape.m), i);
      const auto instance = transported_configuration_class().draw_structured(shape, {}, limits, choices);
      if (!instance) continue;
      ++found;
      EXPECT_NO_THROW(transported_configuration_class().require(instance->bindings));
    }
  }
  EXPECT_GT(found, 10);
}

/// The first one whose map is of finitely many points, or is not.
Instance with_finite_map(bool is_finite) {
  for (std::uint32_t number = 0;; ++number) {
    auto instance = draw(raw_claim(), {2, 3}, number);
    if (instance && object_in<ConfigurationMap>(instance->bindings, "f").is_finite() == is_finite) return *instance;
  }
}

TEST(TransportedConfigurationClass, AFiniteMapHasTheCircumcentresInItsDomain) {
  const Bindings good = with_finite_map(true).bindings;
  EXPECT_NO_THROW(transported_configuration_class().require(good));
  ConfigurationMap::Finite map = object_in<ConfigurationMap>(good, "f").finite();
  map.points.pop_back();
  map.images.pop_back();
  Bindings bad = good;
  bad["f"] = ObjectPointer(std::make_shared<ConfigurationMap>(map));
  EXPECT_THROW(transported_configuration_class().require(bad), InputError);
  for (const Bindings& simpler : transported_configuration_class().simpler(good)) {
    EXPECT_NO_THROW(transported_configuration_class().require(simpler));
  }
}

TEST(TransportedConfigurationClass, WhatIsNotTheImageOrHasNotTheFourPropertiesIsRefused) {
  const Bindings good = some_transported_configuration().bindings;
  const auto refused = [&good](const std::string& name, const Binding& value) {
    Bindings bad = good;
    bad[name] = value;
    EXPECT_THROW(transported_configuration_class().require(bad), InputError) << name;
  };
  EXPECT_NO_THROW(transported_configuration_class().require(good));
  refused("xi", number(good, "xi") * (Rational(1) - Rational::power_of_two(-60)));
  refused("u", good.at("t"));
  refused("epsilon_j", number(good, "epsilon_j") / Rational(16));
  refused("epsilon_i", number(good, "epsilon_i") * Rational::power_of_two(20));
  refused("epsilon_i", Rational(0));
  refused("epsilon0", Rational(-1));
  refused("delta0", Rational(-1));
  refused("gamma0", Rational(0));
  refused("gamma0", Rational(2));
  refused("gamma0", Rational(9) / Rational(10));
  refused("mu0", Rational(0));
  refused("k", 1L);
  refused("m", 4L);
  auto points = object_of<SimplexObject>(std::get<ObjectPointer>(good.at("u"))).points();
  points[0][0] += Rational::power_of_two(-300);
  refused("u", ObjectPointer(std::make_shared<SimplexObject>(points)));
  Bindings without = good;
  without.erase("f");
  EXPECT_THROW(transported_configuration_class().require(without), InputError);
}

TEST(TransportedConfigurationClass, AWitnessReadsBackBitForBit) {
  for (const bool is_finite : {false, true}) {
    const Instance instance = with_finite_map(is_finite);
    Bindings again = instance.bindings;
    for (const auto& [name, kind] :
         std::map<std::string, std::string>{{"t", "simplex"}, {"u", "simplex"}, {"f", "configuration-map"}}) {
      const auto& object = std::get<ObjectPointer>(instance.bindings.at(name));
      again[name] = full_vocabulary().read(kind, nlohmann::ordered_json::parse(object->json().dump()));
      EXPECT_EQ(std::get<ObjectPointer>(again.at(name))->json(), object->json());
    }
    EXPECT_NO_THROW(transported_configuration_class().require(again));
  }
}

TEST(TransportedConfigurationClass, SimplerInstancesAreInstances) {
  const auto simpler = transported_configuration_class().simpler(some_transported_configuration().bindings);
  EXPECT_FALSE(simpler.empty());
  for (const Bindings& bindings : simpler) EXPECT_NO_THROW(transported_configuration_class().require(bindings));
}

void expect_to_hold(const Claim& claim) {
  const auto all_shapes = transported_configuration_class().shapes();
  const auto shape = all_shapes[*rc::gen::inRange<std::size_t>(0, all_shapes.size())];
  const auto instance = draw(claim, shape, *rc::gen::arbitrary<std::uint32_t>());
  RC_PRE(instance.has_value());
  const Attempt result = attempt(claim, instance->bindings);
  RC_ASSERT(is_proved(result.hypotheses));
  for (const ConclusionOutcome& outcome : result.conclusions) RC_ASSERT(is_proved(outcome.verdict));
}

RC_GTEST_PROP(TransportedConfigurationClass, FacetsStayThickRoundAndNearTheirVertex, ()) {
  expect_to_hold(raw_claim());
}

RC_GTEST_PROP(TransportedConfigurationClass, TheHoopIsHardlyDistorted, ()) { expect_to_hold(hoop_claim()); }

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
