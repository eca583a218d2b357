#include "properties/instances/configuration_geometry.hpp"

#include <cmath>

#include "kernel/simplex/sphere_distance.hpp"

namespace delcert {

namespace {

using Points = SimplexObject::Points;
using Point = std::vector<Rational>;

Rational rounded(double x, unsigned bits) {
  const double steps = std::floor(std::ldexp(x, static_cast<int>(bits)) + 0.5);
  return Rational(static_cast<long>(steps)) * Rational::power_of_two(-static_cast<long>(bits));
}

Rational squared_length(const Point& x) {
  Rational result(0);
  for (const Rational& coordinate : x) result += square(coordinate);
  return result;
}

}  // namespace

Point rational_direction(const std::vector<double>& direction, unsigned bits) {
  constexpr double negligible = 0x1p-20;
  double squared = 0;
  for (const double x : direction) squared += x * x;
  const double length = std::sqrt(squared);
  const double last = length < negligible ? 1.0 : direction.back() / length;
  // From the pole that is farther away.
  const double pole = last >= 0 ? -1.0 : 1.0;
  Point shadow;
  for (std::size_t axis = 0; axis + 1 < direction.size(); ++axis) {
    shadow.push_back(length < negligible ? Rational(0)
                                         : rounded(direction[axis] / length / (1 + std::abs(last)), bits));
  }
  const Rational q = squared_length(shadow);
  Point result;
  for (const Rational& coordinate : shadow) result.push_back(Rational(2) * coordinate / (Rational(1) + q));
  result.push_back((Rational(1) - q) / (Rational(1) + q) * Rational(pole < 0 ? 1 : -1));
  return result;
}

Point point_of_parallel(const Rational& q, const Point& z) {
  const Rational width = Rational(2) * q / (Rational(1) + square(q));
  Point result;
  for (const Rational& coordinate : z) result.push_back(width * coordinate);
  result.push_back((Rational(1) - square(q)) / (Rational(1) + square(q)));
  return result;
}

Points scaled_points(Points points, const Rational& factor) {
  for (Point& point : points) {
    for (Rational& coordinate : point) coordinate *= factor;
  }
  return points;
}

Points mirrored_points(Points points, const Point& normal) {
  const Rational squared = squared_length(normal);
  if (squared == Rational(0)) return points;
  for (Point& point : points) {
    Rational product(0);
    for (std::size_t axis = 0; axis < normal.size(); ++axis) product += point[axis] * normal[axis];
    const Rational factor = Rational(2) * product / squared;
    for (std::size_t axis = 0; axis < normal.size(); ++axis) point[axis] -= factor * normal[axis];
  }
  return points;
}

Points embedded_points(Points points, std::size_t dimension) {
  for (Point& point : points) point.resize(dimension, Rational(0));
  return points;
}

Rational shortened_up(const Rational& x, unsigned bits) {
  return x == Rational(0) ? x : rounded_up(x, binary_exponent(x) - static_cast<long>(bits));
}

Rational shortened_down(const Rational& x, unsigned bits) {
  return x == Rational(0) ? x : rounded_down(x, binary_exponent(x) - static_cast<long>(bits));
}

Rational approximate_hoop(const EdgeGram<Rational>& simplex) {
  constexpr unsigned digits = 64;
  Rational greatest(0);
  for (std::size_t p = 0; p < simplex.vertex_count(); ++p) {
    const auto offset = sphere_offset(simplex, p);
    if (!offset || offset->squared_radius == Rational(0)) return Rational(0);
    // √a − √b without cancellation.
    const Rational sum =
        square_root_lower(offset->squared_shift, digits) + square_root_lower(offset->squared_radius, digits);
    const Rational gap = (offset->squared_shift - offset->squared_radius) / sum;
    greatest = maximum(greatest, (offset->squared_height + square(gap)) / offset->squared_radius);
  }
  return square_root_lower(greatest, digits);
}

}  // namespace delcert
