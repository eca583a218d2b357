#pragma once

#include <limits>

#include "kernel/number/plain_double.hpp"
#include "kernel/simplex/sphere_stack.hpp"

namespace delcert {

template <int m>
struct ApproximateSphere {
  Vector<double, m> centre{};  // frame coordinates
  double squared_radius = std::numeric_limits<double>::infinity();
};

/// The diametric sphere of the simplex with these vertices (1 … m+1 of them, frame coordinates) in doubles, without
/// error bounds; infinite radius for a simplex that looks degenerate.
template <int m, class Vertices>
[[nodiscard]] ApproximateSphere<m> approximate_sphere(const MetricOn<PlainDouble, m>& metric,
                                                      const Vertices& vertices) {
  const auto plain = [](const Vector<double, m>& x) {
    Vector<PlainDouble, m> result;
    for (std::size_t axis = 0; axis < m; ++axis) result[axis] = PlainDouble::exactly(x[axis]);
    return result;
  };
  SphereStack<PlainDouble, m> stack(metric);
  const auto origin = plain(vertices[0]);
  for (std::size_t at = 1; at < vertices.size(); ++at) {
    const auto edge = difference(plain(vertices[at]), origin);
    if (!is_proved(stack.push(edge, metric.squared_norm(edge)))) return {};
  }
  ApproximateSphere<m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result.centre[axis] = (origin[axis] + stack.centre()[axis]).lower();
  result.squared_radius = stack.squared_radius().lower();
  if (!(result.squared_radius >= 0)) return {};
  return result;
}

}  // namespace delcert
