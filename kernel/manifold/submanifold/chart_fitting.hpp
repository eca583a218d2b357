#pragma once

#include <array>
#include <string>
#include <vector>

#include "kernel/chart/sampling_radii.hpp"
#include "kernel/manifold/submanifold/tangent_chart.hpp"
#include "support/error.hpp"
#include "support/progress.hpp"

namespace delcert {

/// The widths of patches that are tried, in quarters of a sampling radius. Most balls of level 2s lie within four and a
/// half of these radii.
inline constexpr std::array patch_quarters{20, 19, 18, 16, 12};

/// Charts about the points of a net, as large as they pass.
struct FittedCharts {
  std::vector<TangentChart> charts;
  Rational slope;         ///< L, for all of them
  Rational patch_factor;  ///< ϱ = this times the sampling radius of the label
};

/// A sampling radius is too large: at these places.
class TooCoarse : public Rejection {
 public:
  TooCoarse(const std::string& reason, std::vector<std::vector<double>> where)
      : Rejection(reason), places(std::move(where)) {}
  std::vector<std::vector<double>> places;
};

/// Charts about these points with the greatest of the factors 5, 19/4, 9/2, 4, 3 for which all of them pass
/// `GraphCheck`, heights and one slope L ≤ 1. Throws TooCoarse, with the label, the place and a sampling radius that
/// would roughly do, if there is none. Precondition: rounding to nearest.
[[nodiscard]] FittedCharts fit_charts(const ZeroSet& zero_set, const std::vector<std::vector<Rational>>& centres,
                                      const SamplingRadii& radii, const Progress& progress);

/// The least number with few binary digits for which (1 + ξ₀)² ≥ 1 + L²: transitions of charts with slopes ≤ L have the
/// distortion ξ₀ at most.
[[nodiscard]] Rational distortion_of_slope(const Rational& slope);

}  // namespace delcert
