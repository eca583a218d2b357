#pragma once

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "properties/instances/instance_class.hpp"
#include "support/error.hpp"

namespace delcert::test {

/// Limits by name, the same for all instances.
class FixedLimits : public Limits {
 public:
  explicit FixedLimits(std::map<std::string, Rational> limits) : limits_(std::move(limits)) {}
  [[nodiscard]] std::optional<Rational> most(const std::string& name, const Bindings&, bool) const override {
    const auto found = limits_.find(name);
    return found == limits_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::map<std::string, Rational> limits_;
};

/// Every object written and read again; the text has to be the same.
inline Bindings read_back(Bindings bindings, const Signature& signature) {
  for (auto& [name, binding] : bindings) {
    auto* object = std::get_if<ObjectPointer>(&binding);
    if (object == nullptr) continue;
    const auto json = (*object)->json();
    *object = full_vocabulary().read(signature.at(name).name, nlohmann::ordered_json::parse(json.dump()));
    EXPECT_EQ((*object)->json(), json);
  }
  return bindings;
}

/// Draws instances of every shape; each has to pass `require`, also after it was written and read back.
/// Returns how many there were with each trait.
inline std::map<Trait, int> check_draws(const InstanceClass& instance_class, const Limits& limits,
                                        std::uint32_t per_shape) {
  std::map<Trait, int> traits;
  int drawn = 0;
  int asked = 0;
  for (const Shape& shape : instance_class.shapes()) {
    for (std::uint32_t number = 0; number < per_shape; ++number) {
      RandomChoices choices(7, stream_of(instance_class.name() + std::to_string(100 * shape.k + shape.m)), number);
      ++asked;
      const auto instance = instance_class.draw(shape, {}, limits, choices);
      if (!instance) continue;
      ++drawn;
      for (const Trait trait : instance->traits) ++traits[trait];
      EXPECT_EQ(std::get<long>(instance->bindings.at("k")), shape.k);
      EXPECT_EQ(std::get<long>(instance->bindings.at("m")), shape.m);
      EXPECT_NO_THROW(instance_class.require(instance->bindings));
      const Bindings back = read_back(instance->bindings, instance_class.signature());
      EXPECT_NO_THROW(instance_class.require(back));
    }
  }
  EXPECT_GE(10 * drawn, 9 * asked) << "more than one draw in ten led to nothing";
  return traits;
}

/// One instance of a class for a test to break.
inline Bindings some_instance(const InstanceClass& instance_class, const Shape& shape, const Limits& limits,
                              std::uint32_t number = 0) {
  for (;; ++number) {
    RandomChoices choices(11, stream_of(instance_class.name()), number);
    if (const auto instance = instance_class.draw(shape, {}, limits, choices)) return instance->bindings;
  }
}

/// Everything that is proposed as simpler is an instance of the class, and there is something.
inline void check_simpler(const InstanceClass& instance_class, const Bindings& bindings) {
  const auto simpler = instance_class.simpler(bindings);
  EXPECT_FALSE(simpler.empty());
  for (const Bindings& each : simpler) EXPECT_NO_THROW(instance_class.require(each));
}

}  // namespace delcert::test
