#include "kernel/sample/lattice_net.hpp"

#include <string>

#include "kernel/random/counter_random.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::uint64_t most_lattice_points = 4000000;
constexpr unsigned most_displacement_digits = 1024;

/// All integer points first … last in every coordinate, divided, and with the centres of the cells if asked.
template <int m>
std::vector<Vector<Rational, m>> box(std::int64_t first, std::int64_t last, const LatticeNet& lattice) {
  std::uint64_t count = lattice.centred ? 2 : 1;
  for (int axis = 0; axis < m; ++axis) {
    count *= static_cast<std::uint64_t>(last - first + 1);
    if (count > most_lattice_points) throw InputError("a lattice of more than 4000000 points");
  }
  std::vector<Vector<Rational, m>> points;
  points.reserve(count);
  const Integer doubled(std::uint64_t{2} * lattice.divisions);
  std::array<std::int64_t, static_cast<std::size_t>(m)> at;
  at.fill(first);
  while (true) {
    for (int centre = 0; centre <= (lattice.centred ? 1 : 0); ++centre) {
      Vector<Rational, m> point;
      for (std::size_t axis = 0; axis < m; ++axis) point[axis] = Rational(Integer(2 * at[axis] + centre), doubled);
      points.push_back(point);
    }
    std::size_t axis = m;
    while (axis > 0 && ++at[axis - 1] > last) {
      at[axis - 1] = first;
      --axis;
    }
    if (axis == 0) return points;
  }
}

template <int m>
void displace(std::vector<Vector<Rational, m>>& points, const LatticeNet& lattice) {
  if (!lattice.displacement_exponent) return;
  const Rational step = Rational::power_of_two(-static_cast<long>(*lattice.displacement_exponent));
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    CounterRandom random(lattice.seed, RandomPurpose::jitter, index, 1);
    for (Rational& coordinate : points[index]) {
      if ((random.next_word() & 1U) == 0) {
        coordinate += step;
      } else {
        coordinate -= step;
      }
    }
  }
}

template <int m>
std::vector<Vector<Rational, m>> in_spatial_order(const FlatSpace<m>& space,
                                                  const std::vector<Vector<Rational, m>>& points, double cell_width,
                                                  const std::optional<double>& box_radius) {
  PointGrid<m> grid(space.metric, box_radius, cell_width, points.size());
  for (const auto& point : points) {
    Vector<double, m> approximate;
    for (std::size_t axis = 0; axis < m; ++axis) approximate[axis] = approximate_double(point[axis]);
    grid.insert(approximate);
  }
  std::vector<Vector<Rational, m>> result;
  result.reserve(points.size());
  for (const std::uint32_t index : grid.spatial_order()) result.push_back(points[index]);
  return result;
}

}  // namespace

template <int m>
std::vector<Vector<Rational, m>> lattice_net(const FlatSpace<m>& space, const LatticeNet& lattice) {
  if (lattice.divisions == 0) throw InputError("a lattice needs at least one division");
  if (lattice.displacement_exponent.value_or(0) > most_displacement_digits) {
    throw InputError("a displacement of 2^-" + std::to_string(*lattice.displacement_exponent) + ": at most 2^-" +
                     std::to_string(most_displacement_digits) + " is supported");
  }
  std::vector<Vector<Rational, m>> points;
  std::optional<double> box_radius;
  if (space.is_torus()) {
    points = box<m>(0, std::int64_t{lattice.divisions} - 1, lattice);
  } else {
    const Integer reach = ceiling_of(*space.ball_radius * Rational(lattice.divisions)) + 4;
    const auto last = reach.convert_to<std::int64_t>();
    points = box<m>(-last, last, lattice);
    box_radius = static_cast<double>(last) / lattice.divisions;
  }
  displace<m>(points, lattice);
  return in_spatial_order<m>(space, points, 1.0 / lattice.divisions, box_radius);
}

#define DELCERT_INSTANTIATE(m) \
  template std::vector<Vector<Rational, m>> lattice_net<m>(const FlatSpace<m>&, const LatticeNet&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
