#pragma once

#include "kernel/manifold/space_form/space_form.hpp"

namespace delcert {

/// Throws Rejection, with the values, unless (factor + 3)·ε ≤ inj(M) and, on a sphere, factor·ε < π/2, for patches
/// B(p_i, factor·ε): then every label is seen at one lift at most within 3ε more than the radius of a patch, the same
/// from all charts that are compared. Throws InputError unless ε > 0 and the form has this dimension.
void require_small_patches(const SpaceForm& form, int dimension, const Rational& sampling_radius, int factor);

}  // namespace delcert
