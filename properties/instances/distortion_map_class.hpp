#pragma once

#include "properties/instances/instance_class.hpp"

namespace delcert {

/// A simplex s, the centre c of one of its circumscribing balls, and a map phi of distortion xi > 0 on a set that holds
/// the vertices, and c if outside = 0; the images t of s and c_image of c; offset = |c − C(σ)|². Linear maps,
/// inversions, smooth maps, transition functions of the built-in manifolds, and bare maps of the vertices and c, which
/// are more than the paper's homeomorphisms: its proofs use these points only.
[[nodiscard]] const InstanceClass& distortion_map_class();

}  // namespace delcert
