#include "properties/instances/flat_groups.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/number/ladder.hpp"
#include "kernel/simplex/independence.hpp"
#include "properties/instances/exact_point.hpp"

namespace delcert {

namespace {

constexpr unsigned group_bits = 40;

/// The vertices of a regular simplex of circumradius 1 about the origin.
std::vector<std::vector<double>> regular_simplex(std::size_t dimension) {
  if (dimension == 0) return {{}};
  const double low = 1.0 / static_cast<double>(dimension);
  std::vector<std::vector<double>> result = regular_simplex(dimension - 1);
  for (auto& point : result) {
    for (double& x : point) x *= std::sqrt(1 - low * low);
    point.push_back(-low);
  }
  result.emplace_back(dimension, 0.0);
  result.back().back() = 1;
  return result;
}

Rational short_number(double x) {
  return Rational::exactly(std::ldexp(std::floor(std::ldexp(x, group_bits)), -static_cast<int>(group_bits)));
}

double jitter(Choices& choices) {
  constexpr double still = 0.5;
  const double u = choices.unit();
  return u < still ? 0.0 : (u - still) * (u - still);
}

}  // namespace

std::optional<FlatGroups> flat_groups(const Shape& shape, Choices& choices) {
  const auto k = static_cast<std::size_t>(shape.k);
  const auto m = static_cast<std::size_t>(shape.m);
  const double split = choices.unit();
  const double radius = choices.happens(0.5) ? 1.0 : 2 * choices.unit();
  double height = 2 * choices.unit() + 0x1p-12;
  if (choices.happens(0.5)) height = std::ldexp(height, -static_cast<int>(choices.between(1, 12)));
  const double amplitude = jitter(choices);
  // Halves mostly.
  const std::size_t first =
      split < 0.6 ? k / 2 : std::min(k - 1, static_cast<std::size_t>((split - 0.6) / 0.4 * double(k)));
  const std::size_t second = k - 1 - first;
  FlatGroups result;
  result.axis = k - 1;
  result.height = short_number(height);
  const auto add = [&](const std::vector<double>& point, double scale, std::size_t from, double level) {
    std::vector<double> full(m, 0.0);
    for (std::size_t axis = 0; axis < point.size(); ++axis) full[from + axis] = scale * point[axis];
    full[k - 1] = level;
    for (std::size_t axis = 0; axis < m; ++axis)
      full[axis] += amplitude * std::min(1.0, height) * (2 * choices.unit() - 1);
    std::vector<Rational> exact;
    for (const double x : full) exact.push_back(short_number(x));
    result.points.push_back(std::move(exact));
  };
  for (const auto& point : regular_simplex(first)) add(point, 1.0, 0, 0.0);
  for (const auto& point : regular_simplex(second)) add(point, radius, first, height);
  if (!are_affinely_independent(result.points)) return std::nullopt;
  return result;
}

FiniteMap centre_between_groups(const CentredSimplex& simplex, const FlatGroups& groups, const Rational& xi,
                                Choices& choices) {
  // With q_i = c + s(p_i − c), r² = |p_i − c|², c half-way, and c + d along the axis for the image of c, the squared
  // distances are s²r² + d² ± shd; they are (1 ± ξ)²r² for shd = 2ξr² and d² = (1 + ξ² − s²)r².
  const double distortion = approximate_double(xi) * (1 - 0x1p-20);
  const double squared_radius = approximate_double(simplex.squared_radius);
  const double height = approximate_double(groups.height);
  const double whole = 1 + distortion * distortion;
  const double inner = whole * whole - 16 * distortion * distortion * squared_radius / (height * height);
  const double least = 1 - distortion;
  double shrunk = inner > 0 ? std::sqrt((whole + std::sqrt(inner)) / 2) : least;
  shrunk = std::max(shrunk, least);
  double way = 2 * distortion * squared_radius / (shrunk * height);
  way = std::min(way, std::sqrt(std::max(0.0, (whole - shrunk * shrunk) * squared_radius)));
  // Somewhat less, if chosen.
  if (choices.happens(0.3)) way *= choices.unit();
  if (choices.happens(0.5)) way = -way;
  const Rational factor = Rational::exactly(shrunk);
  FiniteMap map{simplex.points, {}, simplex.points.size() + 1};
  map.points.push_back(simplex.centre);
  for (const auto& point : map.points) {
    map.images.push_back(combined(simplex.centre, factor, combined(point, Rational(-1), simplex.centre)));
  }
  map.images.back()[groups.axis] += Rational::exactly(way);
  return map;
}

}  // namespace delcert
