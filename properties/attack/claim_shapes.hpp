#pragma once

#include <vector>

#include "proofs/formula/claim.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {

/// The shapes that an attack on the claim goes through unless told otherwise: those of its class; for point sets those
/// that the claim's rules allow, k + 1 points in ℝᵐ. Precondition: the claim has an instance class.
[[nodiscard]] std::vector<Shape> usual_shapes(const Claim& claim);

/// Whether an attack on the claim can be told to use a shape.
[[nodiscard]] bool has_shape(const Claim& claim, const Shape& shape);

}  // namespace delcert
