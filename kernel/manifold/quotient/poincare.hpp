#pragma once

#include <string>
#include <vector>

#include "kernel/manifold/quotient/dirichlet_polyhedron.hpp"
#include "kernel/topology/abelian_group.hpp"

namespace delcert {

/// A turn around a ridge from tile to tile: the elements crossed, whose product is 1.
struct RidgeCycle {
  /// Numbers of sides of the polyhedron.
  std::vector<std::size_t> sides;
  /// An enclosure of the sum of the dihedral angles, which is 2π.
  BigInterval angle_sum;
};

/// What Poincaré's theorem says once its conditions hold: the side pairings generate a discrete group that acts freely,
/// P is a fundamental polyhedron, and the cycles are the relations of a presentation.
struct PoincareResult {
  std::vector<RidgeCycle> cycles;
  /// Γ made abelian: H₁ of the quotient.
  AbelianGroup abelianisation;
  /// Of the quotient, by counting classes of faces.
  int euler_characteristic = 0;
};

/// Poincaré's conditions, exactly: every element maps the side of its inverse onto its own; around every ridge the
/// product of the elements is 1 and the dihedral angles sum up to 2π (a multiple of 2π by the product, so enclosures
/// decide); no element maps a ridge onto itself; in dimension 3 the links of the classes of vertices are spheres.
/// Throws Rejection that names the condition, the elements and the values where one fails.
[[nodiscard]] PoincareResult verify_poincare(const InvariantForm& form, const DirichletPolyhedron& polyhedron,
                                             const std::vector<std::string>& names);

}  // namespace delcert
