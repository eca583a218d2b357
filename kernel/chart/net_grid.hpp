#pragma once

#include <cmath>

namespace delcert {

/// Coordinates of nets are multiples of this, so that they are exact doubles after any translation that occurs.
constexpr double net_grid_step = 0x1p-48;

/// The multiple of the step next to x. Needs rounding to nearest.
[[nodiscard]] inline double on_net_grid(double x) { return std::nearbyint(x / net_grid_step) * net_grid_step; }

}  // namespace delcert
