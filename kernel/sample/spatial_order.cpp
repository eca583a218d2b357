#include "kernel/sample/spatial_order.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/chart/model_space.hpp"
#include "kernel/number/plain_double.hpp"

namespace delcert {

template <std::size_t n>
std::vector<std::uint32_t> spatial_order(const std::vector<std::array<double, n>>& points) {
  constexpr unsigned bits = 16;
  constexpr double cells = 1U << bits;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> codes;
  codes.reserve(points.size());
  for (const auto& point : points) {
    std::array<std::uint64_t, n> cell;
    for (std::size_t axis = 0; axis < n; ++axis) {
      cell[axis] = static_cast<std::uint64_t>(std::clamp((point[axis] + 1) / 2 * cells, 0.0, cells - 1));
    }
    std::uint64_t code = 0;
    for (unsigned bit = 0; bit < bits; ++bit) {
      for (std::size_t axis = 0; axis < n; ++axis) code |= ((cell[axis] >> bit) & 1U) << (std::size_t{bit} * n + axis);
    }
    codes.emplace_back(code, static_cast<std::uint32_t>(codes.size()));
  }
  std::sort(codes.begin(), codes.end());
  std::vector<std::uint32_t> order;
  order.reserve(codes.size());
  for (const auto& [code, number] : codes) order.push_back(number);
  return order;
}

template <int m>
std::vector<std::uint32_t> spatial_order_of_lifts(Curvature curvature,
                                                  const std::vector<Vector<double, m>>& coordinates) {
  double size = 1;
  for (const auto& point : coordinates) {
    for (const double coordinate : point) size = std::max(size, std::abs(coordinate));
  }
  std::vector<Vector<double, m + 1>> points;
  points.reserve(coordinates.size());
  for (const auto& point : coordinates) {
    Vector<double, m + 1> at{};
    if (curvature == Curvature::positive) {
      Vector<PlainDouble, m> plain;
      for (std::size_t axis = 0; axis < m; ++axis) plain[axis] = PlainDouble::exactly(point[axis]);
      const auto x = model_point<PlainDouble, m>(curvature, plain);
      for (std::size_t axis = 0; axis <= m; ++axis) at[axis] = x[axis].lower();
    } else {
      for (std::size_t axis = 0; axis < m; ++axis) at[axis] = point[axis] / size;
    }
    points.push_back(at);
  }
  return spatial_order(points);
}

template std::vector<std::uint32_t> spatial_order<2>(const std::vector<std::array<double, 2>>&);
template std::vector<std::uint32_t> spatial_order<3>(const std::vector<std::array<double, 3>>&);
template std::vector<std::uint32_t> spatial_order<4>(const std::vector<std::array<double, 4>>&);
template std::vector<std::uint32_t> spatial_order_of_lifts<2>(Curvature, const std::vector<Vector<double, 2>>&);
template std::vector<std::uint32_t> spatial_order_of_lifts<3>(Curvature, const std::vector<Vector<double, 3>>&);

}  // namespace delcert
