#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "kernel/chart/atlas.hpp"
#include "kernel/chart/net_grid.hpp"
#include "kernel/manifold/gluing/affine_chart.hpp"
#include "kernel/sample/disk_sampling.hpp"

namespace delcert {

/// An affine chart in doubles.
template <int m>
struct PlainChart {
  explicit PlainChart(const AffineChart<m>& chart) {
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

template <int m>
[[nodiscard]] Vector<Rational, m> exact_vector(const Vector<double, m>& x) {
  Vector<Rational, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = Rational::exactly(x[axis]);
  return result;
}

template <int m>
[[nodiscard]] Vector<double, m> on_net_grid(Vector<double, m> x) {
  for (double& coordinate : x) coordinate = on_net_grid(coordinate);
  return x;
}

/// Points of a manifold in affine charts as `DiskSampling` takes them: coordinates about a point are those of its
/// chart. `Space` is the manifold, with
///
///     Place                                      a point of it
///     Place random_place(CounterRandom&)
///     Place moved(const Place&, const Vector&)   with coordinates changed by that much, on the grid of nets
///     Place home_of(const Place&)                the same point as it is kept
///     PlainChart<m> chart_at(const Place&)
///     void insert(index, const Place&, const PlainChart<m>&)
///     Vector stretch_about(const Place&)         about the greatest of points that may be near
///     void visit(const Place&, half_widths, see) see(Lift<m>, offset, matrix), until that returns true, for the
///                                                points in a box about the place: their coordinates less those of
///                                                the place, and their matrix in these coordinates
///
/// In doubles: nothing rests on it. Needs rounding to nearest.
template <int m, class Space>
class AffineNetPoints {
 public:
  using Place = typename Space::Place;
  static constexpr std::size_t most_points = 2000000;

  /// A reference is kept.
  AffineNetPoints(Space& space, double radius) : space_(space), radius_(radius) {}

  bool throw_dart(CounterRandom& random) {
    const Place place = space_.random_place(random);
    if (!is_free(place, scaled(radius_, space_.stretch_about(place)), nullptr)) return false;
    insert(place);
    return true;
  }
  void insert_about(std::uint32_t label, const Vector<double, m>& place) {
    const PlainChart<m>& chart = charts_[label];
    const Place moved = space_.moved(places_[label], upper_applied(chart.inverse, place));
    if (is_free(moved, scaled(radius_, chart.stretch), &chart.matrix)) insert(space_.home_of(moved));
  }
  void look_about(std::uint32_t label, std::vector<Vector<double, m>>& around) const {
    constexpr double reach = DiskSampling<m, AffineNetPoints>::reach;
    std::vector<std::pair<Lift<m>, Vector<double, m>>> seen;
    const PlainChart<m>& chart = charts_[label];
    space_.visit(places_[label], scaled(reach * radius_, chart.stretch),
                 [&](const Lift<m>& lift, const Vector<double, m>& offset, const Matrix<double, m>&) {
                   if (lift.index != label || !lift.is_unmoved()) seen.emplace_back(lift, offset);
                   return false;
                 });
    std::sort(seen.begin(), seen.end());
    around.clear();
    for (const auto& [lift, offset] : seen) {
      const auto place = upper_applied(chart.matrix, offset);
      if (pairing(place, place) <= reach * radius_ * (reach * radius_)) around.push_back(place);
    }
  }
  [[nodiscard]] std::size_t size() const { return places_.size(); }
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }

 private:
  void insert(const Place& place) {
    if (places_.size() == most_points)
      throw Rejection("a net of this radius has more than " + std::to_string(most_points) +
                      " points, which is the most that is supported");
    charts_.push_back(space_.chart_at(place));
    space_.insert(static_cast<std::uint32_t>(places_.size()), place, charts_.back());
    places_.push_back(place);
  }
  [[nodiscard]] bool is_close(const Matrix<double, m>& matrix, const Vector<double, m>& v) const {
    Vector<double, m> seen{};
    for (std::size_t row = 0; row < m; ++row) seen[row] = pairing(matrix[row], v);
    return pairing(seen, seen) < radius_ * radius_;
  }
  /// No point is closer: in this chart, or in its own if there is none.
  [[nodiscard]] bool is_free(const Place& place, const Vector<double, m>& half_widths,
                             const Matrix<double, m>* matrix) const {
    bool result = true;
    space_.visit(place, half_widths,
                 [&](const Lift<m>&, const Vector<double, m>& offset, const Matrix<double, m>& own) {
                   result = !is_close(matrix == nullptr ? own : *matrix, offset);
                   return !result;
                 });
    return result;
  }
  Space& space_;
  double radius_;
  std::vector<Place> places_;
  std::vector<PlainChart<m>> charts_;
};

/// Darts, then points in gaps until there are none. Returns the covering radius, without error bounds.
template <int m, class Points>
[[nodiscard]] double sample_disks(Points& points, double radius, std::uint64_t seed, const Progress& progress) {
  DiskSampling<m, Points> sampling(points, Curvature::zero, radius);
  sampling.throw_darts(seed, progress);
  sampling.fill_gaps(seed, progress);
  return sampling.covering_radius();
}

}  // namespace delcert
