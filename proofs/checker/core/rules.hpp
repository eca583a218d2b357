#pragma once

#include "proofs/checker/core/flat_simplices.hpp"
#include "proofs/checker/geometry/homology.hpp"

namespace delcert::checker::core {

// The rules of docs/levels/core.md. Those of a line presume that those of the lines before have been looked at.

/// core.group, first half: the generators are isometries. Without it there is no Complex.
bool are_isometries(const Data& data, Report& report);

/// core.sign, core.edges, core.facets, core.stars: Theorem C2.
void check_manifold(Complex& complex, Report& report);
/// Of all faces of the simplices, as checker::count_faces: those whose least label is in a range. Precondition: m is 2
/// or 3, check_manifold() has been called, whatever it has found, and the whole certificate has been read.
FaceCount count_faces(const Complex& complex, Label begin, Label end);
/// core.group, core.connected: Theorem C5.
void check_quotient(Complex& complex, Report& report);
/// core.hinges: Theorem C4. `flat`: of a flat torus, else none.
void check_hinges(Complex& complex, FlatSimplices* flat, Report& report);
/// 4.ball, 4.empty.
void check_margins(Complex& complex, const Quantity& circumradius, const Quantity& protection, Report& report);
/// 6.self-delaunay (surfaces).
void check_cotangents(Complex& complex, const Quantity& weight, Report& report);
/// 6.bilipschitz.
void check_stretching(Complex& complex, const Quantity& least, const Quantity& greatest, Report& report);
/// 5.thickness and 5.radius, but for what the injectivity radius has to be.
void check_riemannian_simplices(Complex& complex, const Quantity& thickness, const Quantity& radius, Report& report);

}  // namespace delcert::checker::core
