#include "kernel/sample/hull_distance.hpp"

#include <algorithm>
#include <optional>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// The point of the affine hull nearest to the origin; none if the points are affinely dependent.
template <int m>
std::optional<Vector<Rational, m>> foot(const std::vector<Vector<Rational, m>>& points) {
  Vector<Rational, m> result = points[0];
  std::vector<Vector<Rational, m>> orthogonal;
  for (std::size_t at = 1; at < points.size(); ++at) {
    Vector<Rational, m> edge = difference(points[at], points[0]);
    for (const auto& direction : orthogonal) {
      edge = difference(edge, scaled(pairing(edge, direction) / pairing(direction, direction), direction));
    }
    const Rational squared = pairing(edge, edge);
    if (is_proved(is_zero(squared))) return std::nullopt;
    orthogonal.push_back(edge);
    result = difference(result, scaled(pairing(result, edge) / squared, edge));
  }
  return result;
}

}  // namespace

template <int m>
bool hull_is_outside_ball(const std::vector<Vector<Rational, m>>& points, const Rational& radius) {
  for (unsigned face = 1; face < (1U << points.size()); ++face) {
    std::vector<Vector<Rational, m>> vertices;
    for (std::size_t at = 0; at < points.size(); ++at) {
      if ((face >> at & 1U) != 0) vertices.push_back(points[at]);
    }
    const auto nearest = foot<m>(vertices);
    if (!nearest) continue;
    const Rational squared = pairing(*nearest, *nearest);
    const bool supports = std::all_of(points.begin(), points.end(),
                                      [&](const auto& point) { return pairing(point, *nearest) >= squared; });
    if (supports && squared >= square(radius)) return true;
  }
  return false;
}

#define DELCERT_INSTANTIATE(m) \
  template bool hull_is_outside_ball<m>(const std::vector<Vector<Rational, m>>&, const Rational&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
