#pragma once

#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// Whether the points are affinely independent, decided exactly: true for one point, false where two coincide. By
/// elimination modulo a prime, where independence there is independence; only where it is not found by the Gram matrix.
/// Throws std::invalid_argument unless there is a point and all are of one dimension.
[[nodiscard]] bool are_affinely_independent(const std::vector<std::vector<Rational>>& points);

}  // namespace delcert
