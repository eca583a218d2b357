#pragma once

#include <vector>

#include "kernel/manifold/gluing/chart_gluing.hpp"
#include "kernel/manifold/gluing/piecewise_values.hpp"
#include "kernel/simplex/frame_metric.hpp"

namespace delcert {

/// A point of a chart, by its coordinates there.
template <int m>
struct ChartPoint {
  std::size_t chart = 0;
  Vector<double, m> x{};
};

/// A Riemannian metric on glued charts, in doubles, for nets and the choice of charts; nothing rests on it.
///
/// G⁻¹ at a point is the mean of the standard inner products of covectors of all charts that show it, with weights
/// Π(1 − t_k²)², t_k from −1 to 1 along the sides of their boxes: the same in whatever chart it is computed. With the
/// map τ from a chart that shows x to that of x, it is Σ w·Dτ·Dτᵀ/Σ w.
template <int m>
class GluingMetric {
 public:
  /// Keeps a reference; has scratch memory: one for each thread.
  explicit GluingMetric(const ChartGluing& gluing);

  /// G⁻¹ in the coordinates of the chart. Precondition: rounding to nearest; the point is in the open box.
  [[nodiscard]] Matrix<double, m> inverse_at(const ChartPoint<m>& point);
  /// G, as `rounded_chart` takes it: intervals of one number each.
  [[nodiscard]] Matrix<Interval, m> enclosed_at(const ChartPoint<m>& point);
  /// The places of the point in all charts that show it, itself first.
  [[nodiscard]] std::vector<ChartPoint<m>> places_of(const ChartPoint<m>& point);
  /// That of these from which the rim of the chart's box is farthest, measured with G along its axes.
  [[nodiscard]] ChartPoint<m> deepest_place_of(const ChartPoint<m>& point);

 private:
  struct Link {
    std::size_t transition;
    PiecewiseValues<double> map;
    std::vector<FormulaEvaluation<double>> polynomials;  // of each piece
    std::size_t conditions;
  };
  struct Box {
    Vector<double, m> lowest;
    Vector<double, m> highest;
  };
  /// Where the transition takes the point; false if it is not in its domain.
  [[nodiscard]] bool follow(Link& link, const Vector<double, m>& x, ChartPoint<m>& to);
  [[nodiscard]] double weight(const ChartPoint<m>& point) const;
  [[nodiscard]] double depth(const ChartPoint<m>& point);

  const ChartGluing& gluing_;
  std::vector<Link> links_;
  std::vector<Box> boxes_;
  std::vector<double> values_;
};

}  // namespace delcert
