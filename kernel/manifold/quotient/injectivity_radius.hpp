#pragma once

#include "kernel/manifold/quotient/crystallographic_group.hpp"
#include "kernel/manifold/quotient/dirichlet_polyhedron.hpp"
#include "kernel/manifold/quotient/finite_group.hpp"

namespace delcert {

// Half the least displacement d(x, γx) over all points x and all γ ≠ 1 is the injectivity radius of a quotient of a
// simply connected space form (for the sphere itself: π). What is returned is a lower bound, which none of the
// quotients below falls short of, and an upper bound close to it.

/// Bounds of an injectivity radius.
struct InjectivityRadius {
  /// Certified: no two lifts of a point are closer than twice this. A multiple of 2⁻⁴⁰.
  Rational lower;
  Rational upper;
};

/// Of 𝕊ᵐ/Γ: the least displacement of γ is arccos λ, λ the largest eigenvalue of its symmetric part (γ + γ*)/2. That
/// λ ≤ c holds where c − (γ + γ*)/2 is positive definite, decided exactly for dyadic c, a bisection to 2⁻³².
[[nodiscard]] InjectivityRadius injectivity_radius(const InvariantForm& form, const FiniteGroup& group);

/// Of 𝔼ᵐ/Γ: from the exact least squared displacement.
[[nodiscard]] InjectivityRadius injectivity_radius(const CrystallographicGroup& group);

/// Of ℍᵐ/Γ: half the length of a shortest closed geodesic. Every closed geodesic of length ℓ is, in some lift, the axis
/// of a γ that meets P, so d(o, γo) ≤ ℓ + 2D, and the tiles of that reach are walked (docs/space-forms.md).
/// Precondition: the polyhedron fulfils Poincaré's conditions. Throws as `tiles_near_polyhedron`.
[[nodiscard]] InjectivityRadius injectivity_radius(const InvariantForm& form, const DirichletPolyhedron& polyhedron);

/// The length by which an isometry of ℍᵐ without fixed points in it and at infinity but two moves its axis, from its
/// trace. Precondition: dimension 2 or 3.
[[nodiscard]] BigInterval translation_length(const InvariantForm& form, const FieldMatrix& element);

}  // namespace delcert
