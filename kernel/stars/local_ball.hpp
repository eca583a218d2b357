#pragma once

#include <array>
#include <cstdint>

#include "kernel/chart/chart_view.hpp"
#include "kernel/simplex/sphere_stack.hpp"

namespace delcert {

/// The vertices of an m-simplex as places in a chart view.
template <int m>
using PlaceSimplex = std::array<std::uint32_t, static_cast<std::size_t>(m) + 1>;

template <class S, int m>
using LocalVertices = std::array<Vector<S, m>, static_cast<std::size_t>(m) + 1>;

/// Builds the diametric spheres of the first vertex (the second, if `last` is 0) and the others, `last` at last.
/// Proved if the simplex is certainly non-degenerate; otherwise nothing may be read from the stack.
template <class S, int m>
[[nodiscard]] Verdict build_spheres(SphereStack<S, m>& stack, const MetricOn<S, m>& metric,
                                    const LocalVertices<S, m>& vertices, std::size_t last) {
  const std::size_t first = last == 0 ? 1 : 0;
  const auto push = [&](std::size_t corner) {
    const auto edge = difference(vertices[corner], vertices[first]);
    return stack.push(edge, metric.squared_norm(edge));
  };
  for (std::size_t corner = 0; corner <= m; ++corner) {
    if (corner == first || corner == last) continue;
    if (const Verdict ok = push(corner); !is_proved(ok)) return ok;
  }
  return push(last);
}

/// A lower bound of the thickness of the simplex with these vertices; 0 if it may be degenerate.
/// Precondition: a `FilterGuard` is alive.
template <int m>
[[nodiscard]] double thickness_of(const MetricOn<Filter, m>& metric, const LocalVertices<Filter, m>& vertices) {
  Filter longest(0);
  for (std::size_t a = 0; a <= m; ++a) {
    for (std::size_t b = a + 1; b <= m; ++b) {
      longest = maximum(longest, metric.squared_norm(difference(vertices[b], vertices[a])));
    }
  }
  // The altitude over a facet is ⟨n, e⟩/|n|, n normal to the facet and e an edge that leaves it.
  Filter least(1);
  for (std::size_t apex = 0; apex <= m; ++apex) {
    const std::size_t foot = apex == 0 ? 1 : 0;
    std::array<Vector<Filter, m>, static_cast<std::size_t>(m)> edges{};  // the last entry is not read
    std::size_t next = 0;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      if (corner != foot && corner != apex) edges[next++] = difference(vertices[corner], vertices[foot]);
    }
    const auto covector = wedge(edges);
    const Filter slope = metric.determinant() * pairing(covector, difference(vertices[apex], vertices[foot]));
    if (!is_proved(negation(is_zero(slope)))) return 0;
    least = minimum(least, square(slope) / (metric.squared_norm(metric.raised(covector)) * longest));
  }
  const double result = (square_root(least) / Filter(m)).lower();
  return result > 0 ? result : 0;
}

/// What is certain of the ball that circumscribes a simplex of a chart view, in local coordinates. The power of a point
/// q here is (|q − C|² − R²)/2 in the coordinates of the chart, and half of that divided by 1 + K|q|²/4 in conformal
/// ones.
template <int m>
struct LocalBall {
  /// Whether the simplex is non-degenerate and every other point of the view strictly outside of the closed ball.
  Verdict empty = Verdict::undecided;
  /// Unless proved: the place of a point that is not certainly outside, or the size of the view for a simplex that may
  /// be degenerate.
  std::size_t witness = 0;
  // If proved:
  Vector<Filter, m> centre{};
  Filter squared_radius{};
  std::size_t nearest = 0;  ///< the place of a point of the least power, or the size of the view
  Filter least_power{};  ///< the least of all other points, but no more than that at a distance `look_beyond` outside
};

/// Looks at the circumscribing ball: on the filter; then, for what that leaves undecided, on intervals of 128, 256, …
/// 1024 bits and, where transitions are exact, in rationals.
template <int m>
[[nodiscard]] LocalBall<m> look_at_ball(const ChartView<m>& view, LocalCoordinates coordinates,
                                        const PlaceSimplex<m>& simplex, double look_beyond);

}  // namespace delcert
