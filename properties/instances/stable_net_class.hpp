#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// The class `stable-net`: a perturbed net as two charts see it, with a linear transition.
[[nodiscard]] const InstanceClass& stable_net_class();

}  // namespace delcert
