#pragma once

#include "kernel/stars/star_complex.hpp"

namespace delcert {

/// Level 4 on a metric field (docs/metric-fields.md): what the metric may change powers of points by, with all vertices
/// of a simplex that it may make Delaunay, and how positive they are. Squares of lengths in charts.
struct DelaunayMargin {
  Rational edge;     ///< ℓ: every simplex has an edge at least that long, in the chart of each star
  Rational change;   ///< (m + 1)h(1 + 2sr/(mtℓ)), s = (1 + κ)/(1 − κ), h = 4κr²/(1 − κ)²
  Rational allowed;  ///< ℓδ + δ²

  /// Not negative: the complex is the Delaunay complex for the distance of the metric.
  [[nodiscard]] Rational value() const { return allowed - change; }
};

/// Exact. The margins are those of level 1: δ, t, r. Precondition: 0 ≤ κ < 1; t, r, ℓ > 0.
[[nodiscard]] DelaunayMargin delaunay_margin(Dimension dimension, const Rational& metric_distortion,
                                             const StarMargins& stars, const Rational& edge);

}  // namespace delcert
