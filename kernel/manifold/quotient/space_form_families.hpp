#pragma once

#include "kernel/manifold/quotient/space_form.hpp"

namespace delcert {

// Families of groups by their parameters. What they return is verified like any other description.

/// 𝕊ᵐ: no generators.
[[nodiscard]] SpaceFormDescription sphere(int dimension);

/// ℝPᵐ: x ↦ −x.
[[nodiscard]] SpaceFormDescription projective_space(int dimension);

/// L(p, q): rotations by 2π/p and 2πq/p in two planes, over ℚ(2cos 2π/p). Throws InputError unless p ≥ 3. If p and q
/// have a common divisor, the group does not act freely, and verification says so.
[[nodiscard]] SpaceFormDescription lens_space(int p, int q);

/// The closed orientable surface of genus g of the regular 4g-gon with angles 2π/4g, whose opposite sides are paired by
/// translations, over ℚ(2cos 2π/4g). Throws InputError unless g ≥ 2.
[[nodiscard]] SpaceFormDescription regular_polygon_surface(int genus);

/// M × S¹ for a flat surface M and a circle of this length: every isometry of the plane, and the identity of the line.
/// Throws InputError unless the surface is flat and of dimension 2 and the length above 0.
[[nodiscard]] SpaceFormDescription product_with_circle(const SpaceFormDescription& surface, const Rational& length);

/// ℚ(2cos 2π/n), t = 2cos 2π/n; without a field, as t is rational, for n = 1, 2, 3, 4, 6.
[[nodiscard]] FieldElement::Field real_cyclotomic_field(int n);
/// 2cos 2π/n, an element of that field.
[[nodiscard]] FieldElement double_cosine(const FieldElement::Field& field, int n);

}  // namespace delcert
