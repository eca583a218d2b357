#pragma once

#include <string>

namespace delcert::checker_tests {

/// What a certificate of the sphere as an atlas of its two stereographic charts claims that is false. M is known: what
/// is glued is said to be what x/|x|² says, exactly, at rational points of the boxes, with a reader of formulas of its
/// own; so it is known whether cores cover M, where each chart shows which label, and what the map of level 5 does. The
/// rest is looked at in doubles, and counts above a relative 10⁻⁹: stars and their margins, patches and distortion,
/// counts and homology, and whether the triangles go around the sphere once. What is said may be false without being
/// found so. Returns the first falsehood, or nothing; of another atlas that it is another. Throws what its reader
/// throws of a document that it cannot read.
std::string fault_of_sphere_by_charts(const std::string& text);

}  // namespace delcert::checker_tests
