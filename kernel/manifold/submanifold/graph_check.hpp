#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "kernel/chart/sampling_radii.hpp"
#include "kernel/manifold/submanifold/tangent_chart.hpp"
#include "support/error.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What is wrong with a chart, and whether a larger slope may mend it.
struct GraphFailure {
  std::string reason;
  bool is_slope = false;
};

/// Rules sub.box and sub.graph of docs/submanifolds.md for one chart: the closed cylinder lies inside of the box; on
/// all of it the symmetric part of 1 − Y·Df·N has a norm below 1; M has a point over the centre, at the heights z₀;
/// |z₀| + 9Lϱ/16 < ζ; and where s = |y|/ϱ and |z − z₀| ≤ LϱP(s), P(s) = (2s + 7s²)/16, the slope ‖(Df·N)⁻¹Df·E‖ is at
/// most L(1 + 7s)/8. Then M in the cylinder is the graph of a C¹ map over the whole disc, with slopes of at most L, and
/// no point of M has a height between |z₀|
/// + 9Lϱ/16 and ζ. None if all this is proved; by enclosures on cells into which the cylinder is divided, `undecided`
/// in the reason where more than `most_cells` are needed.
class GraphCheck {
 public:
  /// Keeps a reference. Not for several threads. Precondition of this and of `failure`: rounding to nearest.
  explicit GraphCheck(const ZeroSet& zero_set);
  [[nodiscard]] std::optional<GraphFailure> failure(const TangentChart& chart, const Rational& slope);
  /// For a chart that would pass if ζ were less: whether it passes as it is, that is whether its cylinder is in the box
  /// and fibres are transversal on all of it. False also where more than a few cells are needed.
  [[nodiscard]] bool may_be_as_high(const TangentChart& chart);

 private:
  [[nodiscard]] std::optional<GraphFailure> outside_of_box(const TangentChart& chart) const;
  const ZeroSet& zero_set_;
};

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
