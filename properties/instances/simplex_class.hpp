#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// The class `simplex`: a non-degenerate k-simplex s in ℝᵐ.
[[nodiscard]] const InstanceClass& simplex_class();

}  // namespace delcert
