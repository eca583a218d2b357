#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// `point-and-simplex`: a non-degenerate m-simplex in ℝᵐ, m ≥ 2, and a point, for what a perturbation is tested by
/// (def:extended.good.pert).
[[nodiscard]] const InstanceClass& configuration_point_class();

}  // namespace delcert
