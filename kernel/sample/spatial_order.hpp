#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/chart/curved_functions.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// The numbers of these points in an order that keeps points together that are close: along a Morton curve through the
/// cube [−1, 1]ⁿ. What lies outside is taken to its border; equal cells are in the order of numbers.
template <std::size_t n>
[[nodiscard]] std::vector<std::uint32_t> spatial_order(const std::vector<std::array<double, n>>& points);

/// The same for points of a space form, by conformal coordinates (for curvature 0 of the frame, of any size).
template <int m>
[[nodiscard]] std::vector<std::uint32_t> spatial_order_of_lifts(Curvature curvature,
                                                                const std::vector<Vector<double, m>>& coordinates);

}  // namespace delcert
