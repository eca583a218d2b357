#pragma once

#include <string>

#include "proofs/drawing/formats/gluings.hpp"

namespace delcert {

/// Regina's isomorphism signature of a connected triangulation: the same text for two of them exactly if they are the
/// same up to the numbers of simplices and vertices. Source: Burton, "The Pachner graph and the simplification of
/// 3-sphere triangulations" (2011), in the characters of Regina 4.90 and later. Takes (m + 1)! times the square of the
/// number of simplices; dimensions 2 to 4. Precondition: at least one simplex.
[[nodiscard]] std::string isomorphism_signature(const Gluings& gluings);

}  // namespace delcert
