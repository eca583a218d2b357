#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// Finite sets of points with the constraints that a claim states (`PointRules`); they may coincide and be dependent.
[[nodiscard]] const InstanceClass& point_set_class();

}  // namespace delcert
