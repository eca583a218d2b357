#include "kernel/sample/metric_field_net.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/chart/net_grid.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/sample/disk_sampling.hpp"
#include "kernel/sample/spatial_order.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_points = 2000000;
constexpr double cell_factor = 1.5;

template <int m>
Vector<Rational, m> exactly(const Vector<double, m>& x) {
  Vector<Rational, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = Rational::exactly(x[axis]);
  return result;
}

/// A chart in doubles.
template <int m>
struct PlainChart {
  PlainChart(const MetricField<m>& field, const Vector<double, m>& x) {
    const auto gram = [&] {
      const RoundingGuard guard;
      return field.template at<Interval>(exactly<m>(x));
    }();
    const AffineChart<m> chart = rounded_chart<m>(gram);
    for (std::size_t row = 0; row < m; ++row) {
      for (std::size_t column = 0; column < m; ++column) {
        matrix[row][column] = approximate_double(chart.matrix()[row][column]);
        inverse[row][column] = approximate_double(chart.inverse()[row][column]);
      }
      stretch[row] = std::sqrt(approximate_double(chart.squared_stretch(row)));
    }
  }
  Matrix<double, m> matrix;
  Matrix<double, m> inverse;
  Vector<double, m> stretch;
};

/// The points of a metric field as `DiskSampling` takes them: coordinates about a point are those of its chart.
template <int m>
class MetricFieldPoints {
 public:
  MetricFieldPoints(const MetricField<m>& field, double radius)
      : field_(field), radius_(radius), cells_(cell_widths()) {}

  bool throw_dart(CounterRandom& random) {
    Vector<double, m> x;
    for (double& coordinate : x) coordinate = random.next_unit();
    x = on_grid(x);
    if (!is_free(x)) return false;
    insert(x);
    return true;
  }
  void insert_about(std::uint32_t label, const Vector<double, m>& place) {
    const auto x = on_grid(sum(points_[label], applied_triangle(charts_[label].inverse, place)));
    if (is_free_in_chart(label, x)) insert(x);
  }
  void look_about(std::uint32_t label, std::vector<Vector<double, m>>& around) const {
    constexpr double reach = DiskSampling<m, MetricFieldPoints>::reach;
    std::vector<Lift<m>> seen;
    const auto& chart = charts_[label];
    cells_.visit(points_[label], scaled(reach * radius_, chart.stretch), [&](const Lift<m>& lift) {
      seen.push_back(lift);
      return false;
    });
    std::sort(seen.begin(), seen.end());
    around.clear();
    for (const Lift<m>& lift : seen) {
      if (lift.index == label && lift.is_unmoved()) continue;
      const auto place = applied_triangle(chart.matrix, offset(lift, points_[label]));
      if (pairing(place, place) <= reach * radius_ * (reach * radius_)) around.push_back(place);
    }
  }
  [[nodiscard]] std::size_t size() const { return points_.size(); }

  [[nodiscard]] std::vector<Vector<Rational, m>> ordered() const {
    std::vector<Vector<Rational, m>> result;
    for (const std::uint32_t label : spatial_order_of_lifts<m>(Curvature::zero, points_))
      result.push_back(exactly<m>(points_[label]));
    return result;
  }

 private:
  /// By the charts at some points.
  [[nodiscard]] Vector<double, m> cell_widths() const {
    constexpr std::uint32_t samples = 16;
    Vector<double, m> widths{};
    for (std::uint32_t sample = 0; sample < samples; ++sample) {
      CounterRandom random(0, RandomPurpose::jitter, sample, 0);
      Vector<double, m> x;
      for (double& coordinate : x) coordinate = random.next_unit();
      widths = sum(widths, scaled(cell_factor * radius_ / samples, PlainChart<m>(field_, x).stretch));
    }
    return widths;
  }

  [[nodiscard]] static Vector<double, m> on_grid(Vector<double, m> x) {
    for (double& coordinate : x) {
      coordinate = on_net_grid(coordinate);
      coordinate -= std::floor(coordinate);
    }
    return x;
  }

  void insert(const Vector<double, m>& x) {
    if (points_.size() == most_points)
      throw Rejection("a net of this radius has more than " + std::to_string(most_points) +
                      " points, which is the most that is supported");
    cells_.insert(static_cast<std::uint32_t>(points_.size()), x);
    points_.push_back(x);
    charts_.emplace_back(field_, x);
    for (std::size_t axis = 0; axis < m; ++axis)
      greatest_stretch_[axis] = std::max(greatest_stretch_[axis], charts_.back().stretch[axis]);
  }

  [[nodiscard]] Vector<double, m> offset(const Lift<m>& lift, const Vector<double, m>& from) const {
    Vector<double, m> result;
    for (std::size_t axis = 0; axis < m; ++axis)
      result[axis] = points_[lift.index][axis] + static_cast<double>(lift.shift[axis]) - from[axis];
    return result;
  }
  [[nodiscard]] bool is_close(const Matrix<double, m>& matrix, const Vector<double, m>& v) const {
    const auto seen = applied_triangle(matrix, v);
    return pairing(seen, seen) < radius_ * radius_;
  }

  /// No point is closer in its own chart.
  [[nodiscard]] bool is_free(const Vector<double, m>& x) const {
    bool result = true;
    cells_.visit(x, scaled(radius_, greatest_stretch_), [&](const Lift<m>& lift) {
      result = !is_close(charts_[lift.index].matrix, offset(lift, x));
      return !result;
    });
    return result;
  }
  /// No point is closer in the chart of this label.
  [[nodiscard]] bool is_free_in_chart(std::uint32_t label, const Vector<double, m>& x) const {
    bool result = true;
    cells_.visit(x, scaled(radius_, charts_[label].stretch), [&](const Lift<m>& lift) {
      result = !is_close(charts_[label].matrix, offset(lift, x));
      return !result;
    });
    return result;
  }

  const MetricField<m>& field_;
  double radius_;
  TorusCells<m> cells_;
  std::vector<Vector<double, m>> points_;
  std::vector<PlainChart<m>> charts_;
  Vector<double, m> greatest_stretch_{};
};

}  // namespace

template <int m>
MetricFieldNet<m> metric_field_net(const MetricField<m>& field, const Rational& radius, std::uint64_t seed,
                                   const Progress& progress) {
  if (radius <= Rational(0)) throw InputError("the radius of a net is above 0");
  // A vector of the length of the radius is a 1/8 long at most, in coordinates.
  if (Rational(64) * square(radius) >= field.eigenvalue_bounds().lower)
    throw Rejection(
        field.description().name +
        ": the radius of a net is below an eighth of the square root of the least eigenvalue of the metric: "
        "take at most " +
        exact_text(fitting_sampling_radius(field.eigenvalue_bounds())));
  MetricFieldPoints<m> points(field, approximate_double(radius));
  DiskSampling<m, MetricFieldPoints<m>> sampling(points, Curvature::zero, approximate_double(radius));
  sampling.throw_darts(seed, progress);
  sampling.fill_gaps(seed, progress);
  return {points.ordered(), sampling.covering_radius()};
}

template MetricFieldNet<2> metric_field_net<2>(const MetricField<2>&, const Rational&, std::uint64_t, const Progress&);
template MetricFieldNet<3> metric_field_net<3>(const MetricField<3>&, const Rational&, std::uint64_t, const Progress&);

}  // namespace delcert
