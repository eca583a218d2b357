#include "properties/instances/net_sample.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/number/filter.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/simplex/sphere_stack.hpp"
#include "properties/instances/net_star.hpp"

namespace delcert {

namespace {

constexpr long coordinate_exponent = -16;
/// Points are kept to this many radii beyond the ball, so that the simplices which meet it are there, and a little
/// more.
const Rational& rim() {
  static const Rational result = Rational(Integer(33), Integer(16));
  return result;
}

template <int m>
Rational squared_norm(const Vector<Rational, m>& x) {
  return pairing(x, x);
}

template <int m>
NetPoints<m> poisson_points(long factor, std::uint64_t seed) {
  FlatSpace<m> space;
  space.ball_radius = Rational(factor + 1);
  const auto net = poisson_disk_net<m>(space, Rational(1), seed, no_progress());
  NetPoints<m> points;
  const auto nearest = std::min_element(
      net.begin(), net.end(), [](const auto& a, const auto& b) { return squared_norm<m>(a) < squared_norm<m>(b); });
  points.push_back({});
  for (auto at = net.begin(); at != net.end(); ++at) {
    if (at == nearest) continue;
    auto point = difference(*at, *nearest);
    for (Rational& coordinate : point) coordinate = rounded_down(coordinate, coordinate_exponent);
    if (squared_norm<m>(point) <= square(Rational(factor) + rim())) points.push_back(point);
  }
  return points;
}

template <int m>
using Basis = std::array<Vector<Rational, m>, static_cast<std::size_t>(m)>;

template <int m>
Basis<m> lattice_basis(Choices& choices) {
  const Rational half = Rational::power_of_two(-1);
  const auto side = [&choices] {
    return Rational(Integer(1), Integer(2)) + choices.fraction(6) * Rational(Integer(1), Integer(2));
  };
  Basis<m> basis{};
  for (std::size_t axis = 0; axis < m; ++axis) basis[axis][axis] = Rational(1);
  const long kind = choices.between(0, 3);
  if constexpr (m == 2) {
    if (kind == 1) basis[1] = {half, Rational(Integer(13), Integer(15))};
    if (kind == 2) basis[1] = {Rational(0), side()};
    if (kind == 3) basis[1] = {half * choices.fraction(6), side()};
  } else {
    if (kind == 1) basis = {{{-half, half, half}, {half, -half, half}, {half, half, -half}}};
    if (kind == 2) basis = {{{Rational(0), half, half}, {half, Rational(0), half}, {half, half, Rational(0)}}};
    if (kind == 3) {
      basis[1][1] = half + half * side();
      basis[2][2] = half + half * side();
    }
  }
  return basis;
}

/// The points of the lattice in a closed ball about the origin, the origin first.
template <int m>
NetPoints<m> lattice_points(const Basis<m>& basis, const Rational& radius) {
  constexpr long most = m == 2 ? 40 : 20;
  NetPoints<m> points{{}};
  std::array<long, static_cast<std::size_t>(m)> at;
  at.fill(-most);
  const double reach = approximate_double(radius) * 1.001;
  std::array<Vector<double, m>, static_cast<std::size_t>(m)> approximate;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t axis = 0; axis < m; ++axis) approximate[row][axis] = approximate_double(basis[row][axis]);
  }
  while (true) {
    Vector<double, m> rough{};
    for (std::size_t row = 0; row < m; ++row)
      rough = sum(rough, scaled(static_cast<double>(at[row]), approximate[row]));
    if (pairing(rough, rough) <= reach * reach) {
      Vector<Rational, m> point{};
      for (std::size_t row = 0; row < m; ++row) point = sum(point, scaled(Rational(at[row]), basis[row]));
      const Rational squared = squared_norm<m>(point);
      if (squared > Rational(0) && squared <= square(radius)) points.push_back(point);
    }
    std::size_t row = m;
    while (row > 0 && ++at[row - 1] > most) {
      at[row - 1] = -most;
      --row;
    }
    if (row == 0) return points;
  }
}

/// An upper bound of the covering radius of a lattice: the largest ball of its cell at the origin.
template <int m>
Rational lattice_covering_radius(const Basis<m>& basis) {
  const NetPoints<m> points = lattice_points<m>(basis, Rational(3));
  const auto cells = star_cells<m>(points, Rational(2));
  Rational squared(0);
  for (const auto& cell : cells.value()) squared = maximum(squared, squared_norm<m>(centre_of<m>(points, cell)));
  return square_root_upper(squared, 24);
}

/// Points very close to some of them.
template <int m>
void add_close_points(NetPoints<m>& points, const Rational& radius, Choices& choices) {
  const long count = choices.between(1, 4);
  const Rational distance = Rational::power_of_two(-choices.between(1, 12));
  for (long added = 0; added < count; ++added) {
    const auto near = static_cast<std::size_t>(choices.between(0, static_cast<long>(points.size()) / 4));
    Vector<Rational, m> point = points[near];
    for (Rational& coordinate : point)
      coordinate += distance * (Rational(1) + choices.symmetric(4)) * Rational::power_of_two(-1);
    if (squared_norm<m>(point) < square(Rational(8) * radius) &&
        std::find(points.begin(), points.end(), point) == points.end()) {
      points.push_back(point);
    }
  }
}

template <int m>
Vector<Rational, m> random_step(const Rational& length, std::uint64_t seed, std::uint32_t label) {
  const long exponent = binary_exponent(length) - 24;
  const Integer half = floor_of(length * Rational::power_of_two(-exponent));
  CounterRandom random(seed, RandomPurpose::instances, label, 0);
  while (true) {
    Vector<Rational, m> step;
    for (Rational& coordinate : step) {
      coordinate = (Rational(random.next_integer(26)) - Rational(half)) * Rational::power_of_two(exponent);
    }
    if (squared_norm<m>(step) <= square(length)) return step;
  }
}

template <int m>
Vector<Rational, m> outward_step(const Vector<Rational, m>& offset, const Rational& length) {
  Vector<double, m> direction;
  for (std::size_t axis = 0; axis < m; ++axis) direction[axis] = approximate_double(offset[axis]);
  const double norm = std::sqrt(pairing(direction, direction));
  Vector<Rational, m> step{};
  if (!(norm > 0)) return step;
  const long exponent = binary_exponent(length) - 40;
  const Rational shorter = length * (Rational(1) - Rational::power_of_two(-30));
  for (std::size_t axis = 0; axis < m; ++axis) {
    step[axis] = rounded_down(Rational::exactly(direction[axis] / norm) * shorter, exponent);
  }
  return step;
}

template <int m>
Vector<Rational, m> axis_step(const Rational& length, std::uint64_t seed, std::uint32_t label) {
  CounterRandom random(seed, RandomPurpose::instances, label, 1);
  const std::uint32_t word = random.next_word();
  Vector<Rational, m> step{};
  step[(word >> 1U) % m] = (word & 1U) == 0 ? length : -length;
  return step;
}

}  // namespace

template <int m>
NetSample<m> draw_net(long factor, Choices& choices) {
  NetSample<m> result;
  result.family = static_cast<NetFamily>(choices.between(0, 2));
  const auto seed = static_cast<std::uint64_t>(choices.between(0, (1L << 40) - 1));
  if (result.family == NetFamily::poisson) {
    result.radius = Rational(1) + Rational::power_of_two(-12);
    result.points = poisson_points<m>(factor, seed);
  } else {
    const Basis<m> basis = lattice_basis<m>(choices);
    const Rational covering = lattice_covering_radius<m>(basis);
    // In space four corners of a square stay coplanar under equal steps, up to less than the density's certificate can
    // orient; there the steps are of different lengths, and not too small.
    const long finest = m == 2 ? 40 : 14;
    const Rational step =
        result.family == NetFamily::displaced ? Rational::power_of_two(-choices.between(5, finest)) : Rational(0);
    result.radius = covering + Rational(2) * step;
    result.points = lattice_points<m>(basis, (Rational(factor) + rim()) * result.radius);
    for (std::uint32_t at = 1; at < result.points.size(); ++at) {
      CounterRandom random(seed, RandomPurpose::instances, at, 2);
      for (Rational& coordinate : result.points[at]) {
        const std::uint32_t word = random.next_word();
        const Rational length = m == 2 ? step : step * Rational(1 + (word >> 24U)) * Rational::power_of_two(-8);
        coordinate += (word & 1U) == 0 ? length : -length;
      }
    }
  }
  if (choices.happens(0.15)) add_close_points<m>(result.points, result.radius, choices);
  return result;
}

template <int m>
NetSample<m> draw_nearly_degenerate_net(long factor, Choices& choices) {
  Basis<m> basis{};
  constexpr unsigned bits = 12;
  const Rational amount = Rational::power_of_two(-choices.between(1, 12));
  for (std::size_t row = 0; row < m; ++row) {
    basis[row][row] = row == 0 ? Rational(1) : Rational(1) - choices.fraction(bits) / Rational(2);
    for (std::size_t axis = 0; axis < row; ++axis) basis[row][axis] = amount * choices.symmetric(bits);
  }
  NetSample<m> result;
  result.family = NetFamily::lattice;
  result.radius = lattice_covering_radius<m>(basis);
  result.points = lattice_points<m>(basis, (Rational(factor) + rim()) * result.radius);
  return result;
}

template <int m>
std::vector<Vector<Rational, m>> moved_points(const std::vector<Vector<Rational, m>>& points, const Rational& length,
                                              NetMotion motion, const Vector<Rational, m>& centre,
                                              const Rational& reach, std::uint64_t seed) {
  NetPoints<m> result = points;
  if (motion == NetMotion::none || length == Rational(0)) return result;
  for (std::uint32_t at = 0; at < points.size(); ++at) {
    const auto offset = difference(points[at], centre);
    if (motion == NetMotion::outward && squared_norm<m>(offset) > square(reach)) continue;
    const auto step = motion == NetMotion::random ? random_step<m>(length, seed, at)
                      : motion == NetMotion::axis ? axis_step<m>(length, seed, at)
                                                  : outward_step<m>(offset, length);
    result[at] = sum(points[at], step);
  }
  return result;
}

template <int m>
Rational squared_separation(const std::vector<Vector<Rational, m>>& points) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> close;
  {
    const FilterGuard guard;
    std::vector<Vector<Filter, m>> position(points.size());
    for (std::size_t at = 0; at < points.size(); ++at) {
      for (std::size_t axis = 0; axis < m; ++axis) position[at][axis] = scalar_from<Filter>(points[at][axis]);
    }
    const auto metric = FrameMetric<m>::cartesian().template on<Filter>();
    double least = std::numeric_limits<double>::infinity();
    std::vector<double> lower;
    for (std::uint32_t a = 0; a < points.size(); ++a) {
      for (std::uint32_t b = a + 1; b < points.size(); ++b) {
        const Filter squared = metric.squared_norm(difference(position[b], position[a]));
        if (squared.lower() > least) continue;
        least = std::min(least, squared.upper());
        close.emplace_back(a, b);
        lower.push_back(squared.lower());
      }
    }
    std::size_t kept = 0;
    for (std::size_t at = 0; at < close.size(); ++at) {
      if (lower[at] <= least) close[kept++] = close[at];
    }
    close.resize(kept);
  }
  Rational result = squared_norm<m>(difference(points[close[0].first], points[close[0].second]));
  for (const auto& [a, b] : close) result = minimum(result, squared_norm<m>(difference(points[a], points[b])));
  return result;
}

template <int m>
Vector<Rational, m> centre_of(const std::vector<Vector<Rational, m>>& points, const std::vector<std::uint32_t>& cell) {
  const auto metric = FrameMetric<m>::cartesian().template on<Rational>();
  SphereStack<Rational, m> stack(metric);
  for (std::size_t at = 1; at < cell.size() && stack.dimension() < m; ++at) {
    const auto edge = difference(points[cell[at]], points[cell[0]]);
    // A point that depends on the earlier ones is left out.
    (void)stack.push(edge, metric.squared_norm(edge));
  }
  return sum(points[cell[0]], stack.centre());
}

#define DELCERT_INSTANTIATE(m)                                                                                        \
  template NetSample<m> draw_net<m>(long, Choices&);                                                                  \
  template NetSample<m> draw_nearly_degenerate_net<m>(long, Choices&);                                                \
  template std::vector<Vector<Rational, m>> moved_points<m>(const std::vector<Vector<Rational, m>>&, const Rational&, \
                                                            NetMotion, const Vector<Rational, m>&, const Rational&,   \
                                                            std::uint64_t);                                           \
  template Rational squared_separation<m>(const std::vector<Vector<Rational, m>>&);                                   \
  template Vector<Rational, m> centre_of<m>(const std::vector<Vector<Rational, m>>&, const std::vector<std::uint32_t>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
