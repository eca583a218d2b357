#pragma once

#include <algorithm>

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/manifold/manifold_file.hpp"

namespace delcert {

/// The space that a file describes. Precondition: m is its dimension.
template <int m>
[[nodiscard]] FlatSpace<m> flat_space_of(const ManifoldDescription& description) {
  Matrix<Rational, m> gram;
  for (std::size_t row = 0; row < m; ++row) {
    std::copy(description.gram[row].begin(), description.gram[row].end(), gram[row].begin());
  }
  FlatSpace<m> space{FrameMetric<m>(gram), {}};
  if (description.family == ManifoldFamily::euclidean_ball) space.ball_radius = description.radius;
  return space;
}

}  // namespace delcert
