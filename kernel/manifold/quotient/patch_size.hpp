#pragma once

#include <array>

#include "kernel/manifold/quotient/space_form.hpp"

namespace delcert {

/// Throws Rejection, with the values, unless (factor + 3)·ε ≤ inj(M) and, on a sphere, factor·ε < π/2, for patches
/// B(p_i, factor·ε): then every label is seen at one lift at most within 3ε more than the radius of a patch, the same
/// from all charts that are compared. Throws InputError unless ε > 0 and the form has this dimension.
void require_small_patches(const SpaceForm& form, int dimension, const Rational& sampling_radius, int factor);

/// The patch factors that a run chooses from: that of the paper, on which level 0 rests; and a smaller one, which is
/// enough for all other levels.
inline constexpr std::array<int, 2> patch_factors{9, 7};

/// The first of these for which patches are small enough. If there is none, throws Rejection for the last.
[[nodiscard]] int fitting_patch_factor(const SpaceForm& form, int dimension, const Rational& sampling_radius);

}  // namespace delcert
