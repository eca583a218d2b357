#pragma once

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// Volumes, the inscribed ball, dihedral angles, barycentric coordinates, and affine hulls with the distances of points
/// from them. All but the inradius and angles between hulls have rational squares, which are computed once, exactly;
/// on each rung they are roots of rational numbers. Precondition: the kinds of simplices and points are there.
void add_simplex_measures(Vocabulary& vocabulary);

}  // namespace delcert
