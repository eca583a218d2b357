#pragma once

#include <vector>

#include "kernel/number/rational.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// Whether every convex combination of these 1 … m + 1 points of Cartesian ℝᵐ has norm at least `radius`. Exact: some
/// face has a foot y of the perpendicular from the origin with |y| ≥ radius and ⟨v, y⟩ ≥ |y|² for all points v, which
/// is so exactly for the face that holds the nearest point of the hull.
template <int m>
[[nodiscard]] bool hull_is_outside_ball(const std::vector<Vector<Rational, m>>& points, const Rational& radius);

}  // namespace delcert
