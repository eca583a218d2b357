#include "properties/instances/exponential_transition.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/chart/model_space.hpp"
#include "properties/instances/configuration_finite_map.hpp"
#include "properties/instances/configuration_geometry.hpp"
#include "properties/instances/map_object.hpp"
#include "properties/instances/net_object.hpp"

namespace delcert {

namespace {

using Points = SimplexObject::Points;

/// What is farther on a sphere is close to the antipode.
constexpr long farthest_on_a_sphere = 3;
constexpr long most_bits = 4000;

template <int m>
Vector<BigInterval, m> enclosed(const ExactPoint& point, const Rational& unit) {
  Vector<BigInterval, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = BigInterval(point[axis] / unit);
  return result;
}

/// The exponent to which images are rounded. Precondition: two of the points are different.
long rounding_exponent(const Points& points, const Rational& distortion) {
  constexpr long margin = 44;
  std::optional<Rational> least;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational squared = squared_distance_between(points[i], points[j]);
      if (Rational(0) < squared && (!least || squared < *least)) least = squared;
    }
  }
  return binary_exponent(distortion) + binary_exponent(*least) / 2 - margin;
}

Rational farthest_from_origin(const Points& points) {
  Rational result(0);
  for (const ExactPoint& point : points) result = maximum(result, pairing(point, point));
  constexpr unsigned bits = 10;
  return square_root_upper(result, bits);
}

/// About the distortion of the map; 0 if it is below 2⁻¹⁰⁰⁰. Without error bounds.
double approximate_distortion(const ConfigurationMap::Finite& map) {
  double result = 0;
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational before = squared_distance_between(map.points[i], map.points[j]);
      const Rational change = squared_distance_between(map.images[i], map.images[j]) / before - Rational(1);
      const double relative = approximate_double(change);
      result = std::max(result, std::fabs(relative) / (1 + std::sqrt(1 + relative)));
    }
  }
  return result;
}

}  // namespace

std::optional<ConfigurationMap::Finite> rounded_transition(const SpaceObject& space, Points points,
                                                           const Rational& distortion) {
  const long exponent = rounding_exponent(points, distortion);
  const Rational reach = farthest_from_origin(points) + space.unit();
  constexpr long spare_bits = 64;
  constexpr long least_bits = 128;
  const long bits = std::max(least_bits, binary_exponent(reach) - exponent + spare_bits);
  if (bits > most_bits) return std::nullopt;
  const BigInterval::Precision precision(PrecisionBits{static_cast<unsigned>(bits)});
  return with_net_dimension(space.dimension(), [&]<int m>() -> std::optional<ConfigurationMap::Finite> {
    const Curvature curvature = space.curvature();
    const auto frame = inverse_model_frame<BigInterval, m>(curvature, enclosed<m>(space.points()[1], Rational(1)));
    const BigInterval unit(space.unit());
    ConfigurationMap::Finite result{std::move(points), {}, distortion};
    for (const ExactPoint& point : result.points) {
      const auto x = exponential<BigInterval, m>(curvature, enclosed<m>(point, space.unit()));
      const auto seen = scaled(unit, logarithm<BigInterval, m>(curvature, applied(frame, x)));
      ExactPoint image;
      for (const BigInterval& coordinate : seen) {
        if (!coordinate.is_bounded()) return std::nullopt;
        const Rational lower = coordinate.lower();
        if (coordinate.upper() - lower > Rational::power_of_two(exponent)) return std::nullopt;
        image.push_back(rounded_down(lower, exponent));
      }
      result.images.push_back(std::move(image));
    }
    return result;
  });
}

bool is_transition_of(const SpaceObject& space, const ConfigurationMap::Finite& map) {
  const auto transition = rounded_transition(space, map.points, map.distortion);
  if (!transition) return false;
  const Rational last_digit = Rational::power_of_two(rounding_exponent(map.points, map.distortion));
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    for (std::size_t axis = 0; axis < map.points[i].size(); ++axis) {
      if (last_digit < absolute(map.images[i][axis] - transition->images[i][axis])) return false;
    }
  }
  return true;
}

std::optional<ExponentialTransition> exponential_transition(const Points& vertices, const Rational& distortion,
                                                            const Rational& farthest, Choices& choices) {
  // Below it doubles would be 0.
  if (distortion < Rational::power_of_two(-900)) return std::nullopt;
  const Curvature curvature = choices.happens(0.5) ? Curvature::positive : Curvature::negative;
  const Rational distance = farthest * (Rational(1) - choices.fraction(6) * Rational(7) / Rational(8));
  std::vector<double> towards;
  for (std::size_t axis = 0; axis < vertices.front().size(); ++axis) towards.push_back(choices.unit() - 0.5);
  constexpr unsigned direction_bits = 6;
  const ExactPoint direction = rational_direction(towards, direction_bits);
  const bool is_nearly_isometric = choices.happens(0.15);

  Points points = vertices;
  for (ExactPoint& centre : circumcentres_of_facets(vertices)) {
    if (std::find(points.begin(), points.end(), centre) == points.end()) points.push_back(std::move(centre));
  }
  const ExactPoint origin(vertices.front().size(), Rational(0));
  const Rational reach = farthest_from_origin(points) + distance;
  const double goal = approximate_double(distortion);
  // (Q1) of docs/claims/riemannian-constants.md: so large, and the distortion is at most ξ/2.
  double unit_in_reaches = 1 / std::sqrt(goal);
  if (is_nearly_isometric) unit_in_reaches *= 16;
  std::optional<ExponentialTransition> best;
  constexpr int tries = 5;
  constexpr unsigned unit_bits = 12;
  for (int attempt = 0; attempt < tries; ++attempt) {
    const Rational least_unit =
        curvature == Curvature::positive ? Rational(1) / Rational(farthest_on_a_sphere) : Rational::power_of_two(-3);
    const Rational unit = shortened_up(reach * maximum(Rational::exactly(unit_in_reaches), least_unit), unit_bits);
    const ExactPoint centre = combined(origin, conformal_length(curvature, distance / unit), direction);
    auto space = std::make_shared<const SpaceObject>(curvature, unit, std::vector<ExactPoint>{origin, centre});
    auto map = rounded_transition(*space, points, distortion);
    if (!map) break;
    const double share = approximate_distortion(*map) / goal;
    const bool is_kept = is_distorted_at_most(*map);
    if (is_kept) best = ExponentialTransition{std::move(space), *std::move(map)};
    constexpr double near_enough = 0.9;
    constexpr double aim = 0.97;
    if (is_nearly_isometric || !(share > 0) || (is_kept && share > near_enough)) break;
    // The distortion goes as the curvature, nearly. Beyond the bound it goes back by a little more.
    unit_in_reaches *= std::sqrt((is_kept ? share : std::max(share, 1.0) * 1.05) / aim);
  }
  return best;
}

}  // namespace delcert
