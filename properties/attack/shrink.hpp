#pragma once

#include <functional>

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// Makes an instance simpler as long as it keeps a property: in turn the simpler instances of its class, the first that
/// has the property and is shorter to write down is taken, until none is or `most_tries` have been asked.
/// The result has the property if the given bindings have it.
[[nodiscard]] Bindings shrunk(const InstanceClass& instance_class, Bindings bindings,
                              const std::function<bool(const Bindings&)>& has_property, std::size_t most_tries = 4000);

/// How long it is to write down: points and dimensions first, then characters.
[[nodiscard]] std::size_t written_size(const InstanceClass& instance_class, const Bindings& bindings);

}  // namespace delcert
