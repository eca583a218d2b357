#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// The class `adaptive-sampling`: a Lipschitz sizing function on ℝᵐ, two samples, and a centre.
[[nodiscard]] const InstanceClass& adaptive_sampling_class();

}  // namespace delcert
