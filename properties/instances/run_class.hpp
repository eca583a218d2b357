#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// The class `run`: a finished run of the algorithm on a flat torus.
[[nodiscard]] const InstanceClass& run_class();

}  // namespace delcert
