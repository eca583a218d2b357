#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// `curved-net`: a net of a ball of a sphere or a hyperbolic space and its perturbation, with the sampling radii in two
/// exponential charts and certified bounds of the distortion of these and of the transition between them.
[[nodiscard]] const InstanceClass& curved_net_class();

}  // namespace delcert
