#include "kernel/sample/net_measure.hpp"

#include <cmath>

#include "kernel/number/exact_text.hpp"
#include "kernel/sample/covering.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// ε is rounded up to this many binary digits: far less than the 0.1 % that it may exceed the covering radius by.
constexpr long measured_digits = 30;

/// The radius of a ball of which each point would have its share of the volume.
template <int m>
double usual_distance(const FlatSpace<m>& space, std::size_t points) {
  const double volume = space.is_torus() ? std::sqrt(approximate_double(space.metric.determinant()))
                                         : std::pow(2 * approximate_double(*space.ball_radius), m);
  return std::pow(volume / static_cast<double>(points), 1.0 / m);
}

/// A lower bound of the distance of x to the net.
template <int m>
Rational distance_lower(const FlatSpace<m>& space, const PointSet<m>& net, const Vector<double, m>& x) {
  const auto metric = space.metric.template on<Rational>();
  std::vector<Lift<m>> near;
  PointGrid<m> grid(space.metric, space.box_radius(), usual_distance(space, net.size()), net.size());
  for (const auto& point : net.approximate_all()) grid.insert(point);
  Vector<Rational, m> centre;
  for (std::size_t axis = 0; axis < m; ++axis) centre[axis] = Rational::exactly(x[axis]);
  for (double distance = usual_distance(space, net.size()); near.empty(); distance *= 2) grid.near(x, distance, near);
  // The nearest point is no farther than the nearest one seen, so one more look at that distance sees it.
  const auto squared_distance = [&](const Lift<m>& lift) {
    Vector<Rational, m> offset = difference(net.exact(Label(lift.index)), centre);
    for (std::size_t axis = 0; axis < m; ++axis) offset[axis] += Rational(lift.shift[axis]);
    return metric.squared_norm(offset);
  };
  Rational best = squared_distance(near.front());
  near.clear();
  grid.near(x, approximate_double(square_root_upper(best, 60)), near);
  for (const auto& lift : near) best = minimum(best, squared_distance(lift));
  return square_root_lower(best, 60);
}

}  // namespace

template <int m>
NetDensity<m> measure_density(const FlatSpace<m>& space, const PointSet<m>& net, const std::optional<Rational>& nominal,
                              const Progress& progress, const std::vector<LiftedSimplex<m>>& known) {
  progress("measure density", 0, 1);
  if (nominal && *nominal <= Rational(0)) {
    throw InputError("the nominal sampling radius " + exact_text(*nominal) + " is not above 0");
  }
  if (net.size() <= m) throw Rejection("a net needs more than " + std::to_string(m) + " points");
  const double usual = nominal ? approximate_double(*nominal) : usual_distance(space, net.size());
  Covering<m> covering = cover_net<m>(space, net, usual, {}, known);
  NetDensity<m> result;
  result.covering_radius_lower = distance_lower(space, net, covering.farthest_centre);
  const Rational& upper = covering.radius_upper;
  result.sampling_radius = rounded_up(upper, binary_exponent(upper) - measured_digits) +
                           Rational::power_of_two(binary_exponent(upper) - measured_digits);
  if (nominal && *nominal > upper && *nominal * Rational(1000) <= Rational(1001) * result.covering_radius_lower) {
    result.sampling_radius = *nominal;
  }
  if (result.sampling_radius * Rational(1000) > Rational(1001) * result.covering_radius_lower && space.is_torus()) {
    throw Rejection("the sampling radius that can be certified, " + exact_text(result.sampling_radius) +
                    ", exceeds the covering radius by more than a factor 1.001");
  }
  result.simplices = std::move(covering.simplices);
  progress("measure density", 1, 1);
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                       \
  template NetDensity<m> measure_density<m>(const FlatSpace<m>&, const PointSet<m>&, const std::optional<Rational>&, \
                                            const Progress&, const std::vector<LiftedSimplex<m>>&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
