#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/manifold/quotient/injectivity_radius.hpp"
#include "kernel/manifold/quotient/poincare.hpp"

namespace delcert {

/// A group of isometries of a model space as a file or a family gives it: nothing of it is believed.
struct SpaceFormDescription {
  std::string name;
  InvariantForm form;
  /// Matrices of order m + 1. Flat: besides the translations ℤᵐ. Hyperbolic: one for each pair of sides of the
  /// Dirichlet polyhedron about o.
  std::vector<FieldMatrix> generators;
  /// What H₁ of the quotient is said to be, as `name_of` writes it, and the order of a finite group.
  std::optional<std::string> first_homology;
  std::optional<std::size_t> order;
};

/// A closed manifold X/Γ, X = 𝕊ᵐ, 𝔼ᵐ or ℍᵐ, whose group has been verified.
struct SpaceForm {
  SpaceFormDescription description;
  bool is_orientable = true;
  AbelianGroup first_homology;
  InjectivityRadius injectivity_radius;
  /// What was verified, according to the curvature: one of the three.
  std::optional<FiniteGroup> finite;
  std::optional<CrystallographicGroup> crystallographic;
  std::optional<DirichletPolyhedron> polyhedron;
  std::optional<PoincareResult> cycles;

  [[nodiscard]] const InvariantForm& form() const { return description.form; }
  /// All γ with d(o, γo) ≤ radius, the identity among them, and possibly some that are farther; all of a finite group.
  [[nodiscard]] std::vector<FieldMatrix> elements_within(const Rational& radius) const;
};

/// Verifies the group: generators preserve the form and are no identity; then a finite group is closed and acts freely,
/// a flat one is crystallographic and acts freely, a hyperbolic one fulfils Poincaré's conditions. H₁ and the order
/// must be what the description says: otherwise the group may be one of another manifold. Throws Rejection that begins
/// with the name and says what fails: the generator, the relation, the value.
[[nodiscard]] SpaceForm verify_space_form(const SpaceFormDescription& description);

}  // namespace delcert
