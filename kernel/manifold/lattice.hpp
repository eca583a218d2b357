#pragma once

#include <vector>

#include "kernel/chart/point_grid.hpp"

namespace delcert {

/// The squared length of a shortest non-zero vector of ℤᵐ in this metric: the square of the systole of the flat
/// torus, whose injectivity radius is half the systole. Exact, by enumeration of all integer vectors that could be
/// as short as a basis vector. Throws InputError if the basis is so skewed that this is more than 10⁷ vectors.
template <int m>
[[nodiscard]] Rational squared_systole(const FrameMetric<m>& metric);

}  // namespace delcert
