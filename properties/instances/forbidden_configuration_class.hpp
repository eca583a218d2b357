#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// `forbidden-configuration`: a forbidden configuration (def:forbidden.config) of dimension k + 1 in ℝᵐ, 2 ≤ k ≤ m,
/// and the parameters of its set. For k = 1 there is none under the hypotheses of lem:prop.forbid.cfg.
[[nodiscard]] const InstanceClass& forbidden_configuration_class();

}  // namespace delcert
