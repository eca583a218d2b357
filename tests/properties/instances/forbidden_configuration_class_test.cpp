#include "properties/instances/forbidden_configuration_class.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "kernel/simplex/cayley_menger.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// What the lemma's hypotheses, with μ₀ ≤ 1, leave.
std::optional<Instance> draw(const Shape& shape, std::uint32_t number) {
  static const Claim claim = find_claim("properties-of-forbidden-configurations-mended");
  static const HypothesisLimits limits(claim);
  RandomChoices choices(3, static_cast<std::uint32_t>(shape.k * 16 + shape.m), number);
  return forbidden_configuration_class().draw(shape, {}, limits, choices);
}

Instance some_configuration(const Shape& shape = {2, 2}) {
  for (std::uint32_t number = 0;; ++number) {
    if (auto instance = draw(shape, number)) return *instance;
  }
}

const SimplexObject& simplex_of(const Bindings& bindings) {
  return object_of<SimplexObject>(std::get<ObjectPointer>(bindings.at("t")));
}

TEST(ForbiddenConfigurationClass, DrawsOfEveryShapeAreInstancesAndFewAreDiscarded) {
  std::set<Trait> traits;
  for (const Shape& shape : forbidden_configuration_class().shapes()) {
    constexpr std::uint32_t count = 20;
    std::uint32_t kept = 0;
    for (std::uint32_t number = 0; number < count; ++number) {
      const auto instance = draw(shape, number);
      if (!instance) continue;
      ++kept;
      traits.insert(instance->traits.begin(), instance->traits.end());
      EXPECT_NO_THROW(forbidden_configuration_class().require(instance->bindings));
    }
    EXPECT_GE(kept * 5, count * 4);
  }
  EXPECT_EQ(traits, (std::set<Trait>{Trait::boundary, Trait::nearly_degenerate, Trait::cospherical}));
}

TEST(ForbiddenConfigurationClass, WhatIsNoForbiddenConfigurationIsRefused) {
  const Bindings good = some_configuration().bindings;
  const auto refused = [&good](const std::string& name, const Binding& value) {
    Bindings bad = good;
    bad[name] = value;
    EXPECT_THROW(forbidden_configuration_class().require(bad), InputError) << name;
  };
  refused("gamma0", Rational(0));
  refused("gamma0", Rational(2));
  refused("gamma0", Rational(9) / Rational(10));
  refused("delta0", Rational(-1));
  refused("mu0", Rational(0));
  refused("mu0", Rational(3));
  refused("rho0", Rational(-1));
  refused("epsilon", std::get<Rational>(good.at("epsilon")) / Rational(2));
  refused("perturbed_mu0", Rational(3));
  refused("perturbed_epsilon", std::get<Rational>(good.at("perturbed_epsilon")) * Rational(2));
  refused("k", 3L);
  refused("m", 3L);
  refused("m", Rational(2));
  auto points = simplex_of(good).points();
  points[0][0] += Rational(1) / Rational(32);
  refused("t", ObjectPointer(std::make_shared<SimplexObject>(points)));
  points.pop_back();
  refused("t", ObjectPointer(std::make_shared<SimplexObject>(points)));
  refused("t", ObjectPointer(std::make_shared<SimplexObject>(squared_distance_matrix(simplex_of(good).exact_gram()))));
  Bindings without = good;
  without.erase("rho0");
  EXPECT_THROW(forbidden_configuration_class().require(without), InputError);
}

TEST(ForbiddenConfigurationClass, AWitnessReadsBackBitForBit) {
  const Instance instance = some_configuration({3, 4});
  const auto json = simplex_of(instance.bindings).json();
  Bindings again = instance.bindings;
  again["t"] = full_vocabulary().read("simplex", nlohmann::ordered_json::parse(json.dump()));
  EXPECT_EQ(simplex_of(again).points(), simplex_of(instance.bindings).points());
  EXPECT_NO_THROW(forbidden_configuration_class().require(again));
}

TEST(ForbiddenConfigurationClass, SimplerInstancesAreInstances) {
  const auto simpler = forbidden_configuration_class().simpler(some_configuration().bindings);
  EXPECT_FALSE(simpler.empty());
  for (const Bindings& bindings : simpler) EXPECT_NO_THROW(forbidden_configuration_class().require(bindings));
}

TEST(ForbiddenConfigurationClass, ThePapersClaimIsRefutedByTheHexagonalNet) {
  const Claim claim = find_claim("properties-of-forbidden-configurations");
  const HypothesisLimits limits(claim);
  bool refuted = false;
  for (std::uint32_t number = 0; number < 60 && !refuted; ++number) {
    RandomChoices choices(1, 0, number);
    const auto instance = forbidden_configuration_class().draw({2, 2}, {}, limits, choices);
    if (!instance || std::get<Rational>(instance->bindings.at("mu0")) <= Rational(1)) continue;
    forbidden_configuration_class().require(instance->bindings);
    const Attempt result = attempt(claim, instance->bindings);
    ASSERT_EQ(result.hypotheses, Verdict::proved);
    for (std::size_t i = 0; i < claim.conclusions.size(); ++i) {
      const bool is_diameter = claim.conclusions[i].name == "diameter";
      EXPECT_EQ(result.conclusions[i].verdict, is_diameter ? Verdict::refuted : Verdict::proved);
      refuted = refuted || is_diameter;
    }
  }
  EXPECT_TRUE(refuted);
}

RC_GTEST_PROP(ForbiddenConfigurationClass, TheMendedClaimHolds, ()) {
  static const Claim claim = find_claim("properties-of-forbidden-configurations-mended");
  const auto all_shapes = forbidden_configuration_class().shapes();
  const auto shape = all_shapes[*rc::gen::inRange<std::size_t>(0, all_shapes.size())];
  const auto instance = draw(shape, *rc::gen::arbitrary<std::uint32_t>());
  RC_PRE(instance.has_value());
  const Attempt result = attempt(claim, instance->bindings);
  RC_ASSERT(is_proved(result.hypotheses));
  for (const ConclusionOutcome& outcome : result.conclusions) RC_ASSERT(is_proved(outcome.verdict));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
