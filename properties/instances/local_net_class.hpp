#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// The class `local-net`: a net p of a ball B(0, 8ε), certified, and a perturbation q of it.
[[nodiscard]] const InstanceClass& local_net_class();

}  // namespace delcert
