#include "properties/instances/configuration_point_class.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "proofs/formula/simplex_object.hpp"
#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"
#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::optional<Instance> draw(int m, std::uint32_t number) {
  RandomChoices choices(9, static_cast<std::uint32_t>(m), number);
  return configuration_point_class().draw({m, m}, {}, NoLimits(), choices);
}

Bindings thales() {
  return {{"m", 2L},
          {"s", ObjectPointer(std::make_shared<SimplexObject>(SimplexObject::Points{{-1, 0}, {1, 0}, {0, 5}}))},
          {"x", ObjectPointer(std::make_shared<PointObject>(std::vector<Rational>{0, 1}))}};
}

TEST(ConfigurationPointClass, DrawsOfEveryShapeAreInstances) {
  for (const Shape& shape : configuration_point_class().shapes()) {
    constexpr std::uint32_t count = 50;
    std::uint32_t kept = 0;
    for (std::uint32_t number = 0; number < count; ++number) {
      const auto instance = draw(shape.m, number);
      if (!instance) continue;
      ++kept;
      EXPECT_NO_THROW(configuration_point_class().require(instance->bindings));
    }
    EXPECT_GE(kept * 5, count * 4);
  }
}

TEST(ConfigurationPointClass, WhatIsNoInstanceIsRefused) {
  EXPECT_NO_THROW(configuration_point_class().require(thales()));
  const auto refused = [](const std::string& name, const Binding& value) {
    Bindings bad = thales();
    bad[name] = value;
    EXPECT_THROW(configuration_point_class().require(bad), InputError) << name;
  };
  refused("m", 3L);
  refused("x", ObjectPointer(std::make_shared<PointObject>(std::vector<Rational>{0, 1, 2})));
  refused("s", ObjectPointer(std::make_shared<SimplexObject>(SimplexObject::Points{{-1, 0}, {1, 0}})));
  refused("s", ObjectPointer(std::make_shared<SimplexObject>(SimplexObject::Points{{-1, 0}, {1, 0}, {5, 0}})));
}

TEST(ConfigurationPointClass, ThePointOverTheMiddleOfAnEdgeRefutesThatTopSimplicesSuffice) {
  const Claim claim = find_claim("top-simplices-suffice");
  const Attempt result = attempt(claim, thales());
  ASSERT_EQ(result.conclusions.size(), 1U);
  EXPECT_EQ(result.conclusions[0].verdict, Verdict::refuted);
}

TEST(ConfigurationPointClass, SimplerInstancesAreInstancesAndReadBack) {
  const auto simpler = configuration_point_class().simpler(draw(3, 1).value().bindings);
  EXPECT_FALSE(simpler.empty());
  for (Bindings bindings : simpler) {
    for (const std::string name : {"s", "x"}) {
      const auto json = std::get<ObjectPointer>(bindings.at(name))->json();
      bindings[name] = full_vocabulary().read(name == "s" ? "simplex" : "point", json);
      EXPECT_EQ(std::get<ObjectPointer>(bindings.at(name))->json(), json);
    }
    EXPECT_NO_THROW(configuration_point_class().require(bindings));
  }
}

RC_GTEST_PROP(ConfigurationPointClass, TheCircumsphereOfAFaceIsFartherThanTheSphere, ()) {
  static const Claim claim = find_claim("circumspheres-of-faces");
  const auto instance = draw(*rc::gen::inRange(2, 5), *rc::gen::arbitrary<std::uint32_t>());
  RC_PRE(instance.has_value());
  for (const ConclusionOutcome& outcome : attempt(claim, instance->bindings).conclusions) {
    RC_ASSERT(is_proved(outcome.verdict));
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
