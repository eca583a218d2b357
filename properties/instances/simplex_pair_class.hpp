#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// Two k-simplices s and t with corresponding vertices and a number xi with |‖p_i − p_j‖ − ‖p̃_i − p̃_j‖| ≤ ξΔ(σ) for all
/// edges: from a linear map, from moved vertices, from changed edge lengths, from two simplices that have nothing to do
/// with each other. xi is the measured distortion rounded up by at most 2⁻⁴⁰, or the bound that a claim sets.
[[nodiscard]] const InstanceClass& simplex_pair_class();

}  // namespace delcert
