#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "kernel/chart/atlas.hpp"
#include "kernel/chart/model_space.hpp"
#include "kernel/random/counter_random.hpp"

// The whole sphere, or a part of the hyperbolic plane or space, with the charts of a space form and no group: the slow
// way, every point seen from everywhere. And nets to try things on.
namespace delcert::test {

template <int m>
class CurvedPatch final : public Atlas<m> {
 public:
  /// `centres`: conformal coordinates. Hyperbolic: interior are the points closer to o than `interior`.
  CurvedPatch(Curvature curvature, std::vector<Vector<Rational, m>> centres, Rational sampling_radius,
              double interior = std::numeric_limits<double>::infinity())
      : curvature_(curvature),
        centres_(std::move(centres)),
        sampling_radius_(std::move(sampling_radius)),
        net_(std::vector<Vector<Rational, m>>(centres_.size())) {
    const FilterGuard guard;
    for (const auto& centre : centres_) {
      const auto frame = model_frame<Rational, m>(curvature, centre);
      const auto back = inverse_model_frame<Rational, m>(curvature, centre);
      frames_.push_back(frame);
      inverses_.push_back(back);
      ModelPoint<double, m> point;
      for (std::size_t row = 0; row <= m; ++row) point[row] = approximate_double(frame[row][0]);
      places_.push_back(point);
      interior_.push_back(std::acosh(std::max(point[0], 1.0)) < interior);
    }
  }

  [[nodiscard]] Curvature curvature() const { return curvature_; }
  [[nodiscard]] std::size_t size() const override { return centres_.size(); }
  [[nodiscard]] const FrameMetric<m>& metric() const override { return metric_; }
  [[nodiscard]] const Rational& sampling_radius(Label) const override { return sampling_radius_; }
  [[nodiscard]] bool is_interior(Label i) const override { return interior_[i.value]; }
  [[nodiscard]] const PointSet<m>& net() const override { return net_; }
  [[nodiscard]] std::vector<Sighting<m>> neighbours(Label i) const override {
    std::vector<Sighting<m>> result;
    sightings(i, 9 * approximate_double(sampling_radius_), result);
    return result;
  }
  void sightings(Label i, double distance, std::vector<Sighting<m>>& out) const override {
    out.clear();
    const double half = distance / 2 * (1 + 0x1p-20);
    const double chord = 2 * (curvature_ == Curvature::positive ? std::sin(half) : std::sinh(half));
    for (std::uint32_t j = 0; j < size(); ++j) {
      double squared = 0;
      for (std::size_t axis = 0; axis <= m; ++axis) {
        const double step = places_[j][axis] - places_[i.value][axis];
        squared += (axis == 0 ? sign_of(curvature_) : 1) * step * step;
      }
      if (squared <= chord * chord * (1 + 0x1p-20)) out.push_back({j, {}});
    }
  }
  [[nodiscard]] Vector<Filter, m> carry(Label i, const Sighting<m>& seen,
                                        const Vector<Filter, m>& home) const override {
    return carried_in<Filter>(i, seen, home);
  }
  [[nodiscard]] Vector<BigInterval, m> carry(Label i, const Sighting<m>& seen,
                                             const Vector<BigInterval, m>& home) const override {
    return carried_in<BigInterval>(i, seen, home);
  }
  [[nodiscard]] std::optional<Vector<Rational, m>> carry(Label, const Sighting<m>&,
                                                         const Vector<Rational, m>&) const override {
    return std::nullopt;
  }
  [[nodiscard]] bool has_exact_transitions() const override { return false; }

 private:
  template <class S>
  Vector<S, m> carried_in(Label i, const Sighting<m>& seen, const Vector<S, m>& home) const {
    if (seen.index == i.value) return home;
    ModelMatrix<S, m> matrix;
    const auto exact = product(inverses_[i.value], frames_[seen.index]);
    for (std::size_t row = 0; row <= m; ++row) {
      for (std::size_t column = 0; column <= m; ++column) matrix[row][column] = scalar_from<S>(exact[row][column]);
    }
    return logarithm<S, m>(curvature_, applied(matrix, exponential<S, m>(curvature_, home)));
  }

  Curvature curvature_;
  std::vector<Vector<Rational, m>> centres_;
  Rational sampling_radius_;
  PointSet<m> net_;
  FrameMetric<m> metric_ = FrameMetric<m>::cartesian();
  std::vector<ModelMatrix<Rational, m>> frames_;
  std::vector<ModelMatrix<Rational, m>> inverses_;
  std::vector<ModelPoint<double, m>> places_;
  std::vector<bool> interior_;
};

/// Points of a dense random cloud, each chosen as far from those before as possible, until all are within `radius`:
/// conformal coordinates, multiples of 2⁻³⁰. Hyperbolic: those with |a| ≤ `extent`.
template <int m>
std::vector<Vector<Rational, m>> farthest_point_net(Curvature curvature, double radius, std::size_t cloud,
                                                    std::uint32_t seed, double extent = 0) {
  CounterRandom random(seed, RandomPurpose::instances, 0, 0);
  std::vector<Vector<double, m>> coordinates;
  std::vector<ModelPoint<double, m>> places;
  while (places.size() < cloud) {
    ModelPoint<double, m> x{};
    double squared = 0;
    for (double& entry : x) {
      entry = 2 * random.next_unit() - 1;
      squared += entry * entry;
    }
    Vector<double, m> a;
    if (curvature == Curvature::positive) {
      if (squared > 1 || squared < 0x1p-6 || x[0] < -0.99 * std::sqrt(squared)) continue;
      for (std::size_t axis = 0; axis < m; ++axis) a[axis] = 2 * x[axis + 1] / (std::sqrt(squared) + x[0]);
    } else {
      for (std::size_t axis = 0; axis < m; ++axis) a[axis] = extent * x[axis];
    }
    double norm = 0;
    for (double& entry : a) {
      entry = std::round(entry * 0x1p30) * 0x1p-30;
      norm += entry * entry;
    }
    if (curvature == Curvature::negative && norm > extent * extent) continue;
    const double deviation = sign_of(curvature) * norm / 4;
    ModelPoint<double, m> place{};
    place[0] = (1 - deviation) / (1 + deviation);
    for (std::size_t axis = 0; axis < m; ++axis) place[axis + 1] = a[axis] / (1 + deviation);
    coordinates.push_back(a);
    places.push_back(place);
  }
  const double half = radius / 2;
  const double chord = 2 * (curvature == Curvature::positive ? std::sin(half) : std::sinh(half));
  std::vector<double> nearest(cloud, std::numeric_limits<double>::infinity());
  std::vector<Vector<Rational, m>> result;
  for (std::size_t next = 0; nearest[next] > chord * chord;) {
    Vector<Rational, m> exact;
    for (std::size_t axis = 0; axis < m; ++axis) exact[axis] = Rational::exactly(coordinates[next][axis]);
    result.push_back(exact);
    for (std::size_t at = 0; at < cloud; ++at) {
      double squared = 0;
      for (std::size_t axis = 0; axis <= m; ++axis) {
        const double step = places[at][axis] - places[next][axis];
        squared += (axis == 0 ? sign_of(curvature) : 1) * step * step;
      }
      nearest[at] = std::min(nearest[at], squared);
    }
    next = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
  }
  return result;
}

/// A net of the unit sphere.
inline CurvedPatch<2> sphere(const Rational& radius, std::uint32_t seed = 1) {
  return {Curvature::positive, farthest_point_net<2>(Curvature::positive, approximate_double(radius), 20000, seed),
          radius};
}

}  // namespace delcert::test
