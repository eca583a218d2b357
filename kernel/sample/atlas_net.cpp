#include "kernel/sample/atlas_net.hpp"

#include "kernel/sample/affine_net.hpp"
#include "kernel/sample/spatial_order.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Glued charts with their metric.
template <int m>
class GluedSpace {
 public:
  using Place = ChartPoint<m>;

  GluedSpace(const ChartGluing& gluing, double radius) : metric_(gluing) {
    for (std::size_t at = 0; at < gluing.chart_count(); ++at) {
      const auto& chart = gluing.chart(at);
      Shown shown;
      Vector<double, m> widths;
      for (std::size_t axis = 0; axis < m; ++axis) {
        shown.lowest[axis] = approximate_double(chart.domain[axis][0]);
        shown.scale[axis] = 0.5 / approximate_double(chart.domain[axis][1] - chart.domain[axis][0]);
        shown.core_lowest[axis] = approximate_double(chart.core[axis][0]);
        shown.core_width[axis] = approximate_double(chart.core[axis][1] - chart.core[axis][0]);
        widths[axis] = cell_factor * radius * shown.scale[axis];
      }
      shown.cells.emplace_back(widths);
      shown_.push_back(std::move(shown));
    }
  }

  [[nodiscard]] Place random_place(CounterRandom& random) {
    const auto chart = static_cast<std::size_t>(random.next_unit() * static_cast<double>(shown_.size()));
    Place result{chart, {}};
    for (std::size_t axis = 0; axis < m; ++axis)
      result.x[axis] = shown_[chart].core_lowest[axis] + shown_[chart].core_width[axis] * random.next_unit();
    return home_of(result);
  }
  [[nodiscard]] Place moved(const Place& place, const Vector<double, m>& offset) const {
    return {place.chart, on_net_grid<m>(sum(place.x, offset))};
  }
  [[nodiscard]] Place home_of(const Place& place) {
    const Place deepest = metric_.deepest_place_of(place);
    return {deepest.chart, on_net_grid<m>(deepest.x)};
  }
  [[nodiscard]] PlainChart<m> chart_at(const Place& place) {
    return PlainChart<m>(rounded_chart<m>(metric_.enclosed_at(place)));
  }
  void insert(std::uint32_t index, const Place& place, const PlainChart<m>&) {
    for (const Place& there : metric_.places_of(place)) {
      Shown& shown = shown_[there.chart];
      // The metric is the same in whatever chart.
      const PlainChart<m> chart = chart_at(there);
      shown.cells.front().insert(static_cast<std::uint32_t>(shown.seen.size()), in_unit_cube(shown, there.x));
      shown.seen.push_back({index, there.x, chart.matrix});
      for (std::size_t axis = 0; axis < m; ++axis)
        shown.stretch[axis] = std::max(shown.stretch[axis], chart.stretch[axis]);
    }
  }
  [[nodiscard]] const Vector<double, m>& stretch_about(const Place& place) const { return shown_[place.chart].stretch; }
  template <class See>
  void visit(const Place& place, const Vector<double, m>& half_widths, const See& see) const {
    const Shown& shown = shown_[place.chart];
    Vector<double, m> widths;
    for (std::size_t axis = 0; axis < m; ++axis) widths[axis] = half_widths[axis] * shown.scale[axis];
    shown.cells.front().visit(in_unit_cube(shown, place.x), widths, [&](const Lift<m>& lift) {
      if (!lift.is_unmoved()) return false;
      const Seen& seen = shown.seen[lift.index];
      return see(Lift<m>{seen.index, {}, 0}, difference(seen.x, place.x), seen.matrix);
    });
  }

  /// The labels chart by chart, along a curve in each.
  [[nodiscard]] std::vector<std::uint32_t> order_of(const std::vector<Place>& places) const {
    std::vector<std::vector<std::uint32_t>> labels(shown_.size());
    std::vector<std::vector<Vector<double, m>>> coordinates(shown_.size());
    for (std::uint32_t label = 0; label < places.size(); ++label) {
      labels[places[label].chart].push_back(label);
      coordinates[places[label].chart].push_back(places[label].x);
    }
    std::vector<std::uint32_t> result;
    for (std::size_t chart = 0; chart < shown_.size(); ++chart) {
      for (const std::uint32_t at : spatial_order_of_lifts<m>(Curvature::zero, coordinates[chart]))
        result.push_back(labels[chart][at]);
    }
    return result;
  }

 private:
  static constexpr double cell_factor = 1.5;
  struct Seen {
    std::uint32_t index;
    Vector<double, m> x;
    Matrix<double, m> matrix;
  };
  struct Shown {
    Vector<double, m> lowest{};
    Vector<double, m> scale{};  ///< coordinates to the unit cube
    Vector<double, m> core_lowest{};
    Vector<double, m> core_width{};
    Vector<double, m> stretch{};  ///< the greatest
    std::vector<TorusCells<m>> cells;
    std::vector<Seen> seen;
  };
  [[nodiscard]] static Vector<double, m> in_unit_cube(const Shown& shown, const Vector<double, m>& x) {
    Vector<double, m> result;
    for (std::size_t axis = 0; axis < m; ++axis)
      result[axis] = std::clamp(0.25 + (x[axis] - shown.lowest[axis]) * shown.scale[axis], 0.0, 0.75);
    return result;
  }

  GluingMetric<m> metric_;
  std::vector<Shown> shown_;
};

}  // namespace

template <int m>
AtlasNet<m> atlas_net(const ChartGluing& gluing, const Rational& radius, std::uint64_t seed, const Progress& progress) {
  if (radius <= Rational(0)) throw InputError("the radius of a net is above 0");
  GluedSpace<m> space(gluing, approximate_double(radius));
  AffineNetPoints<m, GluedSpace<m>> points(space, approximate_double(radius));
  AtlasNet<m> result{{}, sample_disks<m>(points, approximate_double(radius), seed, progress)};
  for (const std::uint32_t label : space.order_of(points.places()))
    result.places.push_back({points.places()[label].chart, exact_vector<m>(points.places()[label].x)});
  return result;
}

template AtlasNet<2> atlas_net<2>(const ChartGluing&, const Rational&, std::uint64_t, const Progress&);
template AtlasNet<3> atlas_net<3>(const ChartGluing&, const Rational&, std::uint64_t, const Progress&);

}  // namespace delcert
