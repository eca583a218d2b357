#pragma once

#include <string>
#include <string_view>

#include "kernel/manifold/submanifold/triangle_mesh.hpp"

namespace delcert {

/// Reads OFF, or OBJ if `source` ends in ".obj": vertices and triangles, no more; colours of faces, normals and texture
/// are passed over. Decimals are the exact fractions that they are written as; exact numbers of delcert are read, too.
/// Throws InputError with file and line for anything else, for faces that are no triangles of three different vertices,
/// and for a vertex in no face.
[[nodiscard]] TriangleMesh parse_mesh(std::string_view text, const std::string& source);

/// The fraction that a decimal such as -0.125, 12 or 1.5e-3 is. Throws InputError for anything else, and for an
/// exponent beyond ±400.
[[nodiscard]] Rational parse_decimal(std::string_view text);

}  // namespace delcert
