#pragma once

#include "properties/instances/choices.hpp"
#include "properties/instances/configuration_geometry.hpp"

namespace delcert {

/// k + 2 points of the unit sphere of ℝᵏ. In a sliver, points 0 … k−1 lie on the parallel q, and point k on the
/// parallel q + tilt.
struct ConfigurationSkeleton {
  SimplexObject::Points points;
  bool is_sliver = false;
  Rational parallel;
  std::vector<Rational> direction;

  void tilt_by(const Rational& tilt) { points[points.size() - 2] = point_of_parallel(parallel + tilt, direction); }
  /// The sliver: all points but the last.
  [[nodiscard]] SimplexObject::Points sliver() const { return {points.begin(), points.end() - 1}; }
};

/// k + 2 directions of ℝᵏ, spread out; k of them and two of their opposites, if `orthogonal`. Precondition: k ≥ 2.
[[nodiscard]] std::vector<std::vector<double>> spread_directions(std::size_t k, bool orthogonal);

/// How much directions are jittered by: often 0, and mostly little.
[[nodiscard]] double jitter_amplitude(Choices& choices);

/// Points of the unit sphere near these directions, each coordinate of which has changed by at most the amplitude.
[[nodiscard]] SimplexObject::Points jittered(const std::vector<std::vector<double>>& directions, double amplitude,
                                             Choices& choices);

/// From one whose facets are as fat as they can be to any, half of those of k ≥ 3 slivers. Precondition: k ≥ 2.
[[nodiscard]] ConfigurationSkeleton draw_configuration_skeleton(std::size_t k, Choices& choices);

}  // namespace delcert
