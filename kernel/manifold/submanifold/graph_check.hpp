#pragma once

#include <optional>
#include <string>

#include "kernel/manifold/submanifold/tangent_chart.hpp"

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
/// no point of M has a height between |z₀| + 9Lϱ/16 and ζ. None if all this is proved; by enclosures on cells into
/// which the cylinder is divided, `undecided` in the reason where more than `most_cells` are needed.
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

}  // namespace delcert
