#pragma once

#include <rapidcheck.h>

#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>

#include "properties/attack/hypothesis_limits.hpp"
#include "properties/attack/shrink.hpp"
#include "properties/attack/witness.hpp"

namespace delcert {

/// An instance as RapidCheck shows and shrinks it.
struct GeneratedInstance {
  const InstanceClass* its_class = nullptr;
  Bindings bindings;
};

inline void showValue(const GeneratedInstance& instance, std::ostream& out) {
  out << bindings_json(instance.bindings, instance.its_class->signature()).dump(1);
}

/// Simpler instances that take less to write, so that shrinking comes to an end.
[[nodiscard]] inline std::vector<GeneratedInstance> simpler_instances(const GeneratedInstance& instance) {
  const std::size_t size = written_size(*instance.its_class, instance.bindings);
  std::vector<GeneratedInstance> result;
  for (Bindings& bindings : instance.its_class->simpler(instance.bindings)) {
    if (written_size(*instance.its_class, bindings) < size) result.push_back({instance.its_class, std::move(bindings)});
  }
  return result;
}

/// Instances for a claim, of all shapes of its class, costly ones seldom; simpler ones by the class.
[[nodiscard]] inline rc::Gen<GeneratedInstance> instances_for(const Claim& claim) {
  using rc::Shrinkable;
  const InstanceClass* its_class = &instance_class(claim.instance);
  return [claim, its_class](const rc::Random& random, int) -> Shrinkable<GeneratedInstance> {
    rc::Random source = random;
    const std::uint64_t seed = source.next();
    const HypothesisLimits limits(claim);
    const std::vector<Shape> shapes = its_class->shapes();
    std::vector<double> weights;
    for (const Shape& shape : shapes) weights.push_back(1 / static_cast<double>(its_class->cost(shape)));
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    constexpr std::uint32_t most_tries = 100;
    for (std::uint32_t number = 0; number < most_tries; ++number) {
      RandomChoices choices(seed, 0, number);
      double left = choices.unit() * total;
      std::size_t at = 0;
      while (at + 1 < shapes.size() && left >= weights[at]) left -= weights[at++];
      auto instance = draw_instance(claim, limits, shapes[at], choices);
      if (!instance) continue;
      return rc::shrinkable::shrinkRecur(
          GeneratedInstance{its_class, std::move(instance->bindings)},
          [](const GeneratedInstance& from) { return rc::seq::fromContainer(simpler_instances(from)); });
    }
    throw rc::GenerationFailure("no instance in 100 tries");
  };
}

}  // namespace delcert
