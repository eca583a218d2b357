#include "proofs/drawing/chart_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/number/scalar.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/thickness.hpp"

namespace delcert {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

Interval squared_distance(const SymmetricMatrix<Interval>& metric, const std::vector<Interval>& a,
                          const std::vector<Interval>& b) {
  Interval sum(0);
  for (std::size_t row = 0; row < a.size(); ++row) {
    for (std::size_t column = 0; column < a.size(); ++column)
      sum = sum + metric(row, column) * (a[row] - b[row]) * (a[column] - b[column]);
  }
  return sum;
}

/// How the bounds of several charts are brought together, and what is below the measure of any simplex.
struct Measure {
  enum class Extremum { least, greatest } extremum;
  double floor;
};
constexpr Measure protection_measure{Measure::Extremum::least, -unlimited};
constexpr Measure thickness_measure{Measure::Extremum::least, 0};
constexpr Measure circumradius_measure{Measure::Extremum::greatest, 0};

void add_to(MeasureEnclosures& list, std::size_t simplex, const Measure& measure,
            const std::optional<Interval>& value) {
  double& lower = list.lower[simplex];
  double& upper = list.upper[simplex];
  const bool is_bounded = value && std::isfinite(value->lower()) && std::isfinite(value->upper());
  const bool is_unknown = lower == measure.floor && upper == unlimited;
  if (!is_bounded || is_unknown) {
    lower = measure.floor;
    upper = unlimited;
  } else if (std::isnan(lower)) {
    lower = value->lower();
    upper = value->upper();
  } else if (measure.extremum == Measure::Extremum::least) {
    lower = std::min(lower, value->lower());
    upper = std::min(upper, value->upper());
  } else {
    lower = std::max(lower, value->lower());
    upper = std::max(upper, value->upper());
  }
}

}  // namespace

ChartMeasures measures_in_chart(const ShownSimplex& shown, const SymmetricMatrix<Interval>& metric,
                                const Interval& epsilon) {
  ChartMeasures result;
  const EdgeGram<Interval> gram = edge_gram_from_points(shown.vertices, metric);
  if (const auto thickness = delcert::thickness(gram)) result.thickness = *thickness;
  const auto sphere = circumsphere(gram);
  if (!sphere) return result;
  const Interval radius = square_root(sphere->squared_radius);
  result.circumradius = radius / epsilon;
  const std::vector<Interval> centre = circumcentre(*sphere, shown.vertices);
  std::optional<Interval> nearest;
  for (const std::vector<Interval>& other : shown.others) {
    const Interval distance = square_root(squared_distance(metric, other, centre));
    nearest = nearest ? minimum(*nearest, distance) : distance;
  }
  if (!nearest) return result;
  if (shown.complete_radius < unlimited) {
    // What is not shown is at least so far away.
    const std::vector<Interval> origin(centre.size(), Interval(0));
    const Interval beyond =
        Interval::exactly(shown.complete_radius) - square_root(squared_distance(metric, centre, origin));
    nearest = Interval::between(std::min(nearest->lower(), beyond.lower()), nearest->upper());
  }
  result.protection = (*nearest - radius) / epsilon;
  return result;
}

SimplexBounds unmeasured(std::size_t simplices) {
  const std::vector<double> nothing(simplices, std::numeric_limits<double>::quiet_NaN());
  const MeasureEnclosures none{nothing, nothing};
  return {none, none, none};
}

void add(const ChartMeasures& seen, std::size_t simplex, SimplexBounds& bounds) {
  add_to(bounds.protection, simplex, protection_measure, seen.protection);
  add_to(bounds.thickness, simplex, thickness_measure, seen.thickness);
  add_to(bounds.circumradius, simplex, circumradius_measure, seen.circumradius);
}

}  // namespace delcert
