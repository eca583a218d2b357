#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// `curved-configuration`: as `transported-configuration`, with the exponential charts at two points of a sphere or a
/// hyperbolic space for patches j and i.
[[nodiscard]] const InstanceClass& curved_configuration_class();

}  // namespace delcert
