#include "properties/attack/shrink.hpp"

#include <nlohmann/json.hpp>

#include "properties/attack/witness.hpp"
#include "support/error.hpp"

namespace delcert {

std::size_t written_size(const InstanceClass& instance_class, const Bindings& bindings) {
  constexpr std::size_t weight_of_a_dimension = 1000;
  std::size_t result = bindings_json(bindings, instance_class.signature()).dump().size();
  for (const auto& [name, binding] : bindings) {
    if (const long* integer = std::get_if<long>(&binding)) {
      result += weight_of_a_dimension * static_cast<std::size_t>(std::max(0L, *integer));
    }
  }
  return result;
}

Bindings shrunk(const InstanceClass& instance_class, Bindings bindings,
                const std::function<bool(const Bindings&)>& has_property, std::size_t most_tries) {
  const auto keeps = [&](const Bindings& candidate) {
    try {
      instance_class.require(candidate);
      return has_property(candidate);
    } catch (const InputError&) {
      return false;
    } catch (const Undecided&) {
      return false;
    }
  };
  std::size_t tries = 0;
  std::size_t size = written_size(instance_class, bindings);
  for (bool simpler = true; simpler && tries < most_tries;) {
    simpler = false;
    for (Bindings& candidate : instance_class.simpler(bindings)) {
      const std::size_t candidate_size = written_size(instance_class, candidate);
      if (candidate_size >= size) continue;
      if (++tries > most_tries) break;
      if (!keeps(candidate)) continue;
      bindings = std::move(candidate);
      size = candidate_size;
      simpler = true;
      break;
    }
  }
  return bindings;
}

}  // namespace delcert
