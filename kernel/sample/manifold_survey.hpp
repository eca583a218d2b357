#pragma once

#include <cstdint>
#include <vector>

#include "kernel/manifold/submanifold/embedded_manifold.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What random points of M tell of its shape. In doubles, without error bounds: for advice, no claim rests on it.
struct ManifoldSurvey {
  struct Place {
    std::vector<double> x;
    double curvature = 0;  ///< as of `ManifoldSampler`
  };
  std::vector<Place> places;  ///< the greatest curvature first
  /// Both ends of segments along which M comes nearest to itself, where that says more of the reach than the curvature.
  std::vector<std::vector<double>> narrow;
  /// About the reach of M: by Federer's formula the infimum of |y − x|²/(2 dist(y − x, T_xM)). Curvature stands for
  /// points that are near to one another along M.
  double reach = 0;
  double volume = 0;               ///< of M, about
  std::vector<double> curvatures;  ///< in ascending order, at places that are about equally distributed on M
};

/// Of points of M that Newton's method finds from random ones of the box and, in case M is small there, from around
/// these places, at several scales below the radius. No places: none was found. The same for a seed everywhere.
/// Precondition: rounding to nearest.
[[nodiscard]] ManifoldSurvey survey_manifold(const EmbeddedManifold& manifold, double radius,
                                             const std::vector<std::vector<double>>& around, std::uint64_t seed,
                                             const Progress& progress);

}  // namespace delcert
