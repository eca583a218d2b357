#include "properties/instances/configuration_skeleton.hpp"

namespace delcert {

namespace {

using Points = SimplexObject::Points;
using Point = std::vector<Rational>;

}  // namespace

std::vector<std::vector<double>> spread_directions(std::size_t k, bool orthogonal) {
  std::vector<std::vector<double>> result(k + 2, std::vector<double>(k, 0.0));
  for (std::size_t i = 0; i < k; ++i) result[i][i] = 1.0;
  for (std::size_t axis = 0; axis < k; ++axis) {
    result[k][axis] = orthogonal ? (axis == 0 ? -1.0 : 0.0) : -1.0;
    result[k + 1][axis] = orthogonal ? (axis == 1 ? -1.0 : 0.0) : 1.0;
  }
  return result;
}

double jitter_amplitude(Choices& choices) {
  constexpr double still = 0.125;
  const double u = choices.unit();
  return u < still ? 0.0 : (u - still) * (u - still);
}

SimplexObject::Points jittered(const std::vector<std::vector<double>>& directions, double amplitude, Choices& choices) {
  constexpr unsigned bits = 6;
  Points result;
  for (std::vector<double> direction : directions) {
    for (double& x : direction) x += amplitude * (2.0 * choices.unit() - 1.0);
    result.push_back(rational_direction(direction, bits));
  }
  return result;
}

ConfigurationSkeleton draw_configuration_skeleton(std::size_t k, Choices& choices) {
  ConfigurationSkeleton result;
  result.is_sliver = k >= 3 && choices.happens(0.5);
  const double amplitude = jitter_amplitude(choices);
  // Right angles everywhere would make a facet degenerate in three dimensions and more.
  const std::size_t spread_in = result.is_sliver ? k - 1 : k;
  const bool orthogonal = spread_in == 2 && choices.happens(0.75);
  const Points directions = jittered(spread_directions(spread_in, orthogonal), amplitude, choices);
  if (!result.is_sliver) {
    result.points = directions;
    return result;
  }
  result.parallel = Rational(1) - choices.fraction(5) / Rational(2);
  for (const Point& direction : directions) result.points.push_back(point_of_parallel(result.parallel, direction));
  result.direction = directions.back();
  std::vector<double> pole(k, 0.0);
  for (double& x : pole) x = amplitude * (2.0 * choices.unit() - 1.0);
  pole.back() -= 1.0;
  result.points.push_back(rational_direction(pole, 8));
  return result;
}

}  // namespace delcert
