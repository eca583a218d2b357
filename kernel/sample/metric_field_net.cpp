#include "kernel/sample/metric_field_net.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "kernel/sample/affine_net.hpp"
#include "kernel/sample/spatial_order.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr double cell_factor = 1.5;

/// The torus with the charts of a metric field.
template <int m>
class MetricFieldSpace {
 public:
  using Place = Vector<double, m>;

  MetricFieldSpace(const MetricField<m>& field, double radius)
      : field_(field), radius_(radius), cells_(cell_widths()) {}

  [[nodiscard]] Place random_place(CounterRandom& random) const {
    Place x;
    for (double& coordinate : x) coordinate = random.next_unit();
    return in_unit_cube(x);
  }
  [[nodiscard]] Place moved(const Place& x, const Vector<double, m>& offset) const {
    return in_unit_cube(sum(x, offset));
  }
  [[nodiscard]] const Place& home_of(const Place& x) const { return x; }
  [[nodiscard]] PlainChart<m> chart_at(const Place& x) const {
    const auto gram = [&] {
      const RoundingGuard guard;
      return field_.template at<Interval>(exact_vector<m>(x));
    }();
    return PlainChart<m>(rounded_chart<m>(gram));
  }
  void insert(std::uint32_t index, const Place& x, const PlainChart<m>& chart) {
    cells_.insert(index, x);
    points_.push_back(x);
    matrices_.push_back(chart.matrix);
    for (std::size_t axis = 0; axis < m; ++axis)
      greatest_stretch_[axis] = std::max(greatest_stretch_[axis], chart.stretch[axis]);
  }
  [[nodiscard]] const Vector<double, m>& stretch_about(const Place&) const { return greatest_stretch_; }
  template <class See>
  void visit(const Place& x, const Vector<double, m>& half_widths, const See& see) const {
    cells_.visit(x, half_widths, [&](const Lift<m>& lift) {
      Vector<double, m> offset;
      for (std::size_t axis = 0; axis < m; ++axis)
        offset[axis] = points_[lift.index][axis] + static_cast<double>(lift.shift[axis]) - x[axis];
      return see(lift, offset, matrices_[lift.index]);
    });
  }

 private:
  /// By the charts at some points.
  [[nodiscard]] Vector<double, m> cell_widths() const {
    constexpr std::uint32_t samples = 16;
    Vector<double, m> widths{};
    for (std::uint32_t sample = 0; sample < samples; ++sample) {
      CounterRandom random(0, RandomPurpose::jitter, sample, 0);
      Place x;
      for (double& coordinate : x) coordinate = random.next_unit();
      widths = sum(widths, scaled(cell_factor * radius_ / samples, chart_at(x).stretch));
    }
    return widths;
  }
  [[nodiscard]] static Place in_unit_cube(const Place& x) {
    Place result = on_net_grid<m>(x);
    for (double& coordinate : result) coordinate -= std::floor(coordinate);
    return result;
  }

  const MetricField<m>& field_;
  double radius_;
  TorusCells<m> cells_;
  std::vector<Place> points_;
  std::vector<Matrix<double, m>> matrices_;
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
  MetricFieldSpace<m> space(field, approximate_double(radius));
  AffineNetPoints<m, MetricFieldSpace<m>> points(space, approximate_double(radius));
  const double covering_radius = sample_disks<m>(points, approximate_double(radius), seed, progress);
  MetricFieldNet<m> result{{}, covering_radius};
  for (const std::uint32_t label : spatial_order_of_lifts<m>(Curvature::zero, points.places()))
    result.centres.push_back(exact_vector<m>(points.places()[label]));
  return result;
}

template MetricFieldNet<2> metric_field_net<2>(const MetricField<2>&, const Rational&, std::uint64_t, const Progress&);
template MetricFieldNet<3> metric_field_net<3>(const MetricField<3>&, const Rational&, std::uint64_t, const Progress&);

}  // namespace delcert
