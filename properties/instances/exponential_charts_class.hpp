#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// `exponential-charts`: two points of a sphere or a hyperbolic space, seen in the exponential charts at two others.
[[nodiscard]] const InstanceClass& exponential_charts_class();

}  // namespace delcert
