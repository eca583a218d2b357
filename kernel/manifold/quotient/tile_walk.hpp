#pragma once

#include <vector>

#include "kernel/manifold/quotient/dirichlet_polyhedron.hpp"

namespace delcert {

/// All γ with d(o, γo) ≤ radius, the identity first, and possibly some that are farther by a relative 2⁻¹⁰⁰: found by
/// walking from tile to tile, across sides, as long as the distance is at most radius + D, where D is the circumradius
/// of the polyhedron. That none is missed, and what it has to do with d(x, γy), is proved in docs/space-forms.md.
///
/// Precondition: the polyhedron fulfils Poincaré's conditions, and radius ≥ 0. Throws InputError if the walk meets more
/// than `most_tiles` tiles.
[[nodiscard]] std::vector<FieldMatrix> tiles_with_centre_within(const InvariantForm& form,
                                                                const DirichletPolyhedron& polyhedron,
                                                                const BigInterval& radius,
                                                                std::size_t most_tiles = 1000000);

/// All γ whose tile γP meets the closed neighbourhood of P of this radius, and others with d(o, γo) ≤ radius + 2D.
[[nodiscard]] std::vector<FieldMatrix> tiles_near_polyhedron(const InvariantForm& form,
                                                             const DirichletPolyhedron& polyhedron,
                                                             const BigInterval& radius,
                                                             std::size_t most_tiles = 1000000);

}  // namespace delcert
