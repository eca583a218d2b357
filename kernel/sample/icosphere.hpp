#pragma once

#include <cstdint>
#include <vector>

#include "kernel/number/rational.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// A structured net of 𝕊²: the vertices of the icosahedron whose faces are divided by `frequency`, 10f² + 2 points, so
/// that the great-circle arcs of its edges are divided equally. Conformal coordinates, multiples of 2⁻⁴⁸, in the order
/// of a space-filling curve; turned by a fixed rotation, so that −o, which has no coordinates, is none of them. Made in
/// doubles, the same everywhere. Throws InputError for frequency 0 or above 600.
[[nodiscard]] std::vector<Vector<Rational, 2>> icosphere(std::uint32_t frequency);

}  // namespace delcert
