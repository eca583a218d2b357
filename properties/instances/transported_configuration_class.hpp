#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// `transported-configuration`: a simplex t with the properties P1 … P4 (lem:prop.forbid.cfg) for ε_j in patch j, and
/// its image u in patch i under a transition map of certified distortion; ε_i and ε_j differ.
[[nodiscard]] const InstanceClass& transported_configuration_class();

}  // namespace delcert
