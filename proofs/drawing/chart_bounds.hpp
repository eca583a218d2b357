#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "kernel/number/interval.hpp"
#include "kernel/simplex/edge_gram.hpp"
#include "proofs/drawing/simplex_bounds.hpp"

namespace delcert {

/// Enclosures of what is measured of a simplex in one chart, lengths in units of ε. Where intervals cannot tell it from
/// a degenerate one: absent.
struct ChartMeasures {
  std::optional<Interval> protection;
  std::optional<Interval> thickness;
  std::optional<Interval> circumradius;
};

/// A simplex, and the other points that a chart shows.
struct ShownSimplex {
  std::vector<std::vector<Interval>> vertices;
  std::vector<std::vector<Interval>> others;
  /// Every point that is closer than this to the origin of the chart is among them; infinite where that is known of all
  /// that matter.
  double complete_radius = std::numeric_limits<double>::infinity();
};

/// Precondition: a `RoundingGuard` is alive.
[[nodiscard]] ChartMeasures measures_in_chart(const ShownSimplex& shown, const SymmetricMatrix<Interval>& metric,
                                              const Interval& epsilon);

/// Bounds of simplices that no chart has shown as yet: NaN.
[[nodiscard]] SimplexBounds unmeasured(std::size_t simplices);

/// Adds what one chart says of a simplex: the floor and infinity from then on where that chart cannot tell.
void add(const ChartMeasures& seen, std::size_t simplex, SimplexBounds& bounds);

}  // namespace delcert
