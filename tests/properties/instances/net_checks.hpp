#pragma once

#include <gtest/gtest.h>

#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "properties/attack/witness.hpp"
#include "tests/properties/instances/class_checks.hpp"

namespace delcert::test {

/// Draws of one shape of a class without a simplex; each has to pass `require`, also after it was written and read
/// back. Returns how many there were with each trait.
inline std::map<Trait, int> check_net_draws(const InstanceClass& instance_class, const Shape& shape,
                                            const Limits& limits, std::uint32_t count) {
  std::map<Trait, int> traits;
  std::uint32_t drawn = 0;
  for (std::uint32_t number = 0; number < count; ++number) {
    RandomChoices choices(7, stream_of(instance_class.name() + std::to_string(shape.m)), number);
    const auto instance = instance_class.draw(shape, {}, limits, choices);
    if (!instance) continue;
    ++drawn;
    for (const Trait trait : instance->traits) ++traits[trait];
    EXPECT_EQ(std::get<long>(instance->bindings.at("m")), shape.m);
    EXPECT_NO_THROW(instance_class.require(instance->bindings)) << number;
    const auto json = bindings_json(instance->bindings, instance_class.signature());
    const Bindings back = bindings_from(json, full_vocabulary(), instance_class.signature());
    EXPECT_NO_THROW(instance_class.require(back));
    EXPECT_EQ(bindings_json(back, instance_class.signature()), json);
  }
  EXPECT_GE(10 * drawn, 8 * count) << "more than two draws in ten led to nothing";
  return traits;
}

/// What became of the conclusions of a claim on random instances of one shape.
struct ClaimCount {
  int discarded = 0;
  int held = 0;
  int violated = 0;
  int undecided = 0;
};

inline ClaimCount count_outcomes(const Claim& claim, const Shape& shape, std::uint32_t samples) {
  ClaimCount result;
  const HypothesisLimits limits(claim);
  for (std::uint32_t number = 0; number < samples; ++number) {
    RandomChoices choices(5, stream_of(claim.name), number);
    const auto instance = draw_instance(claim, limits, shape, choices);
    if (!instance) {
      ++result.discarded;
      continue;
    }
    const Attempt outcome = attempt(claim, instance->bindings);
    if (!is_proved(outcome.hypotheses)) ++result.discarded;
    for (const auto& conclusion : outcome.conclusions) {
      ++(is_proved(conclusion.verdict)    ? result.held
         : is_refuted(conclusion.verdict) ? result.violated
                                          : result.undecided);
    }
  }
  return result;
}

/// The claim holds on all random instances, and on at least four in five of those drawn its hypotheses do.
inline void check_claim(const std::string& name, const Shape& shape, std::uint32_t samples) {
  const ClaimCount count = count_outcomes(find_claim(name), shape, samples);
  EXPECT_EQ(count.violated, 0) << name;
  EXPECT_EQ(count.undecided, 0) << name;
  EXPECT_GT(count.held, 0) << name;
  EXPECT_LE(5 * static_cast<std::uint32_t>(count.discarded), samples) << name;
}

}  // namespace delcert::test
