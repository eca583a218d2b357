#include "properties/instances/map_draw.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/builtin_manifolds.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/edges.hpp"
#include "properties/instances/pair_image.hpp"

namespace delcert {

namespace {

constexpr unsigned direction_bits = 10;

ExactPoint random_direction(std::size_t dimension, Choices& choices) {
  ExactPoint result;
  for (std::size_t axis = 0; axis < dimension; ++axis) result.push_back(choices.symmetric(direction_bits));
  return result;
}

/// A power of two of about the size of the root.
Rational size_of_root(const Rational& squared) {
  return squared == Rational(0) ? Rational(1) : Rational::power_of_two(binary_exponent(squared) / 2);
}

/// A vector orthogonal to the simplex, 0 if the direction lies in its span.
std::optional<ExactPoint> normal_part(const SimplexObject& simplex, const ExactPoint& direction) {
  const auto& points = simplex.points();
  std::vector<Rational> products;
  for (std::size_t i = 1; i < points.size(); ++i) {
    products.push_back(pairing(direction, combined(points[i], Rational(-1), points[0])));
  }
  const auto solution = GramElimination<Rational>(simplex.exact_gram().gram()).solve(std::move(products));
  if (!solution) return std::nullopt;
  ExactPoint result = direction;
  for (std::size_t i = 1; i < points.size(); ++i) {
    result = combined(result, -solution->x[i - 1], combined(points[i], Rational(-1), points[0]));
  }
  return result;
}

/// The vertices and the centre, all of them in U.
FiniteMap identity_on(const CentredSimplex& simplex) {
  FiniteMap map{simplex.points, {}, simplex.points.size() + 1};
  map.points.push_back(simplex.centre);
  map.images = map.points;
  return map;
}

/// The vertices shrunk towards the first by 1 − ξ.
FiniteMap shrunk_vertices(const CentredSimplex& simplex, const Rational& xi) {
  FiniteMap map = identity_on(simplex);
  for (std::size_t i = 1; i < simplex.points.size(); ++i) {
    map.images[i] = combined(map.points[i], -xi, combined(map.points[i], Rational(-1), map.points[0]));
  }
  return map;
}

/// A little less than ξ, so that roundings fit.
Rational slightly_less(const Rational& xi) { return xi * (Rational(1) - Rational::power_of_two(-45)); }

/// The root rounded down by much less than ξ, relatively.
Rational rounded_root(const Rational& squared, const Rational& xi) {
  constexpr long spare = 64;
  return square_root_lower(squared, static_cast<unsigned>(spare - std::min(0L, binary_exponent(xi))));
}

}  // namespace

std::optional<CentredSimplex> with_centre(const SimplexObject& simplex, bool at_circumcentre, Choices& choices) {
  const auto sphere = circumsphere(simplex.exact_gram());
  if (!sphere) return std::nullopt;
  CentredSimplex result{simplex.points(),
                        circumcentre(*sphere, simplex.points()),
                        {},
                        sphere->squared_radius,
                        squared_longest_edge(simplex.exact_gram())};
  result.smallest = result.centre;
  const std::size_t m = simplex.ambient_dimension();
  const long size = choices.between(-3, 3);
  const ExactPoint direction = random_direction(m, choices);
  if (at_circumcentre || m == simplex.dimension()) return result;
  const auto normal = normal_part(simplex, direction);
  if (!normal) return std::nullopt;
  const Rational scale = size_of_root(sphere->squared_radius) * Rational::power_of_two(size);
  result.centre = combined(result.centre, scale, *normal);
  result.squared_radius += square(scale) * pairing(*normal, *normal);
  return result;
}

LinearMap random_linear_map(std::size_t dimension, const Rational& xi, Choices& choices) {
  std::vector<Rational> factors;
  for (std::size_t axis = 0; axis < dimension; ++axis) factors.push_back(Rational(1) + xi * random_share(choices));
  const bool turns = choices.happens(0.7);
  const ExactPoint before = random_normal(dimension, choices);
  const ExactPoint after = random_normal(dimension, choices);
  LinearMap map{std::vector<ExactPoint>(dimension, ExactPoint(dimension)), ExactPoint(dimension, Rational(0))};
  for (std::size_t column = 0; column < dimension; ++column) {
    ExactPoint image(dimension, Rational(0));
    image[column] = Rational(1);
    if (turns) image = reflected(image, before);
    for (std::size_t axis = 0; axis < dimension; ++axis) image[axis] *= factors[axis];
    if (turns) image = reflected(image, after);
    for (std::size_t row = 0; row < dimension; ++row) map.rows[row][column] = image[row];
  }
  return map;
}

SmoothMap random_smooth_map(const CentredSimplex& simplex, const Rational& xi, Choices& choices) {
  const std::size_t m = simplex.centre.size();
  const Rational unit = size_of_root(simplex.squared_radius);
  SmoothMap map;
  const long count = choices.between(1, 3);
  for (long at = 0; at < count; ++at) {
    SmoothMap::Bump bump{random_direction(m, choices), random_direction(m, choices), choices.symmetric(direction_bits)};
    for (Rational& entry : bump.covector) entry /= unit;
    bump.offset -= pairing(bump.covector, simplex.points[0]);
    map.bumps.push_back(std::move(bump));
  }
  const Rational bound = lipschitz_bound(map);
  if (bound == Rational(0)) return map;
  const Rational exact = slightly_less(xi) / bound;
  const Rational factor = rounded_down(exact, binary_exponent(exact) - 46);
  for (auto& bump : map.bumps) {
    for (Rational& entry : bump.shift) entry *= factor;
  }
  return map;
}

InversionMap random_inversion(const CentredSimplex& simplex, const Rational& xi, Choices& choices) {
  InversionMap map;
  map.centre = simplex.points[0];
  Rational greatest = simplex.squared_radius;
  for (const auto& point : simplex.points) greatest = maximum(greatest, squared_distance_between(point, map.centre));
  map.radius = square_root_upper(greatest, 30);
  // (D/(D − s))² ≤ 1 + ξ, for ξ ≤ ½.
  map.distance = map.radius * (Rational(1) + Rational(25) / (Rational(11) * xi));
  map.squared_power = square(map.distance);
  map.pole = map.centre;
  const auto axis = static_cast<std::size_t>(choices.between(0, static_cast<long>(map.centre.size()) - 1));
  map.pole[axis] += choices.happens(0.5) ? map.distance : -map.distance;
  return map;
}

const std::vector<std::string>& manifolds_with_rational_lattices() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const auto& [name, text] : builtin_manifolds()) {
      if (rational_lattice(name)) result.push_back(name);
    }
    return result;
  }();
  return names;
}

std::optional<TransitionMap> random_transition(std::size_t dimension, Choices& choices) {
  struct Known {
    std::string name;
    std::size_t dimension;
    std::vector<ExactPoint> basis;
  };
  static const std::vector<Known> known = [] {
    std::vector<Known> result;
    for (const std::string& name : manifolds_with_rational_lattices()) {
      result.push_back({name, static_cast<std::size_t>(find_manifold(name).dimension.value), *rational_lattice(name)});
    }
    return result;
  }();
  std::vector<const Known*> fitting;
  for (const Known& each : known) {
    if (each.dimension == dimension) fitting.push_back(&each);
  }
  if (fitting.empty()) return std::nullopt;
  const Known& chosen = *fitting[static_cast<std::size_t>(choices.between(0, static_cast<long>(fitting.size()) - 1))];
  TransitionMap map{chosen.name, {}, ExactPoint(dimension, Rational(0))};
  for (const ExactPoint& row : chosen.basis) {
    map.lift.push_back(choices.between(-2, 2));
    map.translation = combined(map.translation, Rational(map.lift.back()), row);
  }
  return map;
}

FiniteMap displaced_points(const CentredSimplex& simplex, const Rational& xi, Choices& choices) {
  FiniteMap map = identity_on(simplex);
  std::vector<ExactPoint> directions;
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    directions.push_back(random_direction(simplex.centre.size(), choices));
  }
  const Rational unit = size_of_root(simplex.squared_longest);
  const double bound = approximate_double(xi);
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ExactPoint edge = combined(map.points[i], Rational(-1), map.points[j]);
      const ExactPoint motion = combined(directions[i], Rational(-1), directions[j]);
      const Rational squared = pairing(edge, edge);
      // The square of the length grows by the factor 1 + 2λa + λ²b.
      const double a = approximate_double(pairing(edge, motion) * unit / squared);
      const double b = approximate_double(pairing(motion, motion) * square(unit) / squared);
      if (!(b > 0)) continue;
      const double most = bound * (2 + bound);
      const double longest = std::sqrt(a * a + b * most);
      step = std::min(step, a >= 0 ? most / (a + longest) : (longest - a) / b);
      const double least = bound * (2 - bound);
      if (a < 0 && least > 0 && a * a > b * least) step = std::min(step, least / (-a + std::sqrt(a * a - b * least)));
    }
  }
  if (!(step > 0 && step < std::numeric_limits<double>::max())) return map;
  const Rational exact = Rational::exactly(step) * (Rational(1) - Rational::power_of_two(-30));
  const Rational factor = unit * rounded_down(exact, binary_exponent(exact) - 34);
  for (std::size_t i = 0; i < map.points.size(); ++i) map.images[i] = combined(map.points[i], factor, directions[i]);
  return map;
}

std::optional<FiniteMap> lifted_centre(const CentredSimplex& simplex, const Rational& xi, Choices& choices) {
  const SimplexObject object(simplex.points);
  const auto normal = normal_part(object, random_direction(simplex.centre.size(), choices));
  if (!normal) return std::nullopt;
  const Rational squared_normal = pairing(*normal, *normal);
  if (squared_normal == Rational(0) || xi >= Rational(1)) return std::nullopt;
  const Rational less = slightly_less(xi);
  FiniteMap map = shrunk_vertices(simplex, less);
  // C(σ) under the same shrinking, and over it at the height that puts the vertices at a distance of (1 + ξ)r.
  const ExactPoint below = combined(simplex.smallest, -less, combined(simplex.smallest, Rational(-1), map.points[0]));
  const Rational squared_smallest = squared_distance_between(simplex.smallest, map.points[0]);
  const Rational squared_height =
      square(Rational(1) + less) * simplex.squared_radius - square(Rational(1) - less) * squared_smallest;
  map.images.back() = combined(below, rounded_root(squared_height / squared_normal, xi), *normal);
  return map;
}

std::optional<FiniteMap> tilted_centre(const CentredSimplex& simplex, const Rational& xi, Choices& choices) {
  if (simplex.points.size() != 2 || xi >= Rational(1)) return std::nullopt;
  const ExactPoint normal = combined(simplex.centre, Rational(-1), simplex.smallest);
  const Rational squared_normal = pairing(normal, normal);
  if (squared_normal == Rational(0)) return std::nullopt;
  const Rational less = slightly_less(xi);
  FiniteMap map = shrunk_vertices(simplex, less);
  const Rational shorter = Rational(1) - less;
  const Rational one_way(choices.happens(0.5) ? 1 : -1);
  // The foot of the image on the edge, in units of the edge: |x − p̃_0| = (1 ± ξ)r, |x − p̃_1| = (1 ∓ ξ)r.
  const Rational foot =
      (square(shorter) + one_way * Rational(4) * less * simplex.squared_radius / simplex.squared_longest) /
      (Rational(2) * shorter);
  const Rational squared_height =
      square(Rational(1) + one_way * less) * simplex.squared_radius - square(foot) * simplex.squared_longest;
  if (squared_height < Rational(0)) return std::nullopt;
  map.images.back() = combined(combined(map.points[0], foot, combined(map.points[1], Rational(-1), map.points[0])),
                               rounded_root(squared_height / squared_normal, xi), normal);
  return map;
}

FiniteMap with_centre_outside(const CentredSimplex& simplex, Choices& choices) {
  FiniteMap map = identity_on(simplex);
  --map.domain_count;
  const Rational scale = size_of_root(simplex.squared_radius) * Rational::power_of_two(choices.between(-4, 4));
  map.images.back() = combined(simplex.centre, scale, random_direction(simplex.centre.size(), choices));
  return map;
}

Rational certified_distortion(const MapObject& map, const Rational& bound) {
  if (const auto* smooth = std::get_if<SmoothMap>(&map.form())) return lipschitz_bound(*smooth);
  if (std::holds_alternative<TransitionMap>(map.form())) return Rational(0);
  if (const auto* inversion = std::get_if<InversionMap>(&map.form())) {
    const Rational least = inversion->squared_power / square(inversion->distance + inversion->radius);
    const Rational greatest = inversion->squared_power / square(inversion->distance - inversion->radius);
    return maximum(Rational(1) - least, greatest - Rational(1));
  }
  const auto* finite = std::get_if<FiniteMap>(&map.form());
  if (finite == nullptr) return bound;
  Rational result(0);
  for (std::size_t i = 0; i < finite->domain_count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational before = squared_distance_between(finite->points[i], finite->points[j]);
      const Rational after = squared_distance_between(finite->images[i], finite->images[j]);
      if (before == after) continue;
      // |√after − √before|/√before, with √after + √before in the divisor, against cancellation.
      const Rational roots = before + square_root_lower(after * before, 60);
      result = maximum(result, absolute(after - before) / roots);
    }
  }
  if (result == Rational(0)) return result;
  return rounded_up(result, binary_exponent(result) - 50);
}

}  // namespace delcert
