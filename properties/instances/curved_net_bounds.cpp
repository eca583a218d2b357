#include "properties/instances/curved_net_bounds.hpp"

#include <algorithm>

#include "kernel/manifold/quotient/distortion.hpp"
#include "kernel/number/elementary.hpp"
#include "properties/instances/net_object.hpp"
#include "properties/instances/net_sample.hpp"
#include "properties/instances/space_vocabulary.hpp"

namespace delcert {

namespace {

bool is_sphere(const SpaceObject& space) { return space.curvature() == Curvature::positive; }

/// The greatest length of the coordinates of some points, rounded up.
Rational greatest_coordinates(const SpaceObject& p, const SpaceObject& q) {
  Rational squared(0);
  for (const SpaceObject* space : {&p, &q}) {
    for (const ExactPoint& point : space->points()) squared = maximum(squared, pairing(point, point));
  }
  constexpr unsigned bits = 30;
  return square_root_upper(squared, bits);
}

/// The distance from the origin at this length of conformal coordinates, in units, rounded up.
Rational distance_at(Curvature curvature, const Rational& length) {
  const BigInterval half(length / Rational(2));
  return Rational(2) * (curvature == Curvature::positive ? arctangent(half) : area_tangent(half)).upper();
}

}  // namespace

Rational squared_separation_in_coordinates(const SpaceObject& net) {
  return with_net_dimension(net.dimension(), [&]<int m>() {
    return squared_separation<m>(NetObject(net.points(), Rational(1), Rational(0)).vectors<m>());
  });
}

Rational covering_in_space(const SpaceObject& net, const Rational& covering, const Rational& ball) {
  // The segment from a point of the ball to the nearest of the net is no longer in the space than this.
  const Rational factor =
      is_sphere(net) ? Rational(1) : Rational(1) / (Rational(1) - square(ball + covering) / Rational(4));
  return covering * factor * net.unit();
}

Rational ball_in_coordinates(const SpaceObject& net, const Rational& radius) {
  return conformal_length(net.curvature(), radius / net.unit()) * (Rational(1) + Rational::power_of_two(-48));
}

// Charts of spheres stretch, those of hyperbolic spaces shrink, within a ball by `chart_stretch` at most.

Rational radius_in_chart(const SpaceObject& net, const Rational& epsilon, const Rational& radius) {
  if (!is_sphere(net)) return epsilon;
  return epsilon * Rational::exactly(chart_stretch(net.curvature(), (Rational(8) * radius + epsilon) / net.unit()));
}

CurvedNetBounds curved_net_bounds(const SpaceObject& p, const SpaceObject& q, std::size_t j, const Rational& epsilon,
                                  const Rational& radius_i, const Rational& radius_j,
                                  const Rational& squared_separation) {
  const Curvature curvature = p.curvature();
  const Rational& unit = p.unit();
  const auto stretch = [&](const Rational& radius) {
    return Rational::exactly(chart_stretch(curvature, radius / unit));
  };
  const Rational apart = distance_in_space<BigInterval>(p, 0, j)->upper();
  const Rational length = greatest_coordinates(p, q);
  // Of a point from either centre, a length.
  const Rational farthest = distance_at(curvature, length) * unit + apart;
  CurvedNetBounds result;

  result.has_room =
      Rational(8) * radius_i <= Rational(12) * epsilon && Rational(8) * radius_j + apart <= Rational(12) * epsilon;

  // The coordinates of two points about one another are at least t long, and arctan(t/2) ≥ t/2·(1 − t²/12).
  constexpr unsigned bits = 40;
  const Rational t = square_root_lower(squared_separation, bits) / (Rational(1) + square(length) / Rational(4));
  result.separation =
      unit * t * (is_sphere(p) ? Rational(1) - square(t) / Rational(12) : Rational(1) / stretch(farthest));

  Rational displacement(0);
  for (std::size_t at = 0; at < p.size(); ++at) {
    const ExactPoint step = combined(p.points()[at], Rational(-1), q.points()[at]);
    displacement = maximum(displacement, pairing(step, step));
  }
  result.displacement = unit * square_root_upper(displacement, bits) *
                        (is_sphere(p) ? stretch(farthest) : Rational(1) / (Rational(1) - square(length) / Rational(4)));

  const Rational ball = Rational(6) * radius_i / unit;
  result.distortion = Rational::exactly(ball_distortion(curvature, ball, apart / unit));
  result.metric_distortion = Rational::exactly(metric_distortion(curvature, ball));
  return result;
}

std::optional<SpaceObject> points_within(const SpaceObject& q, const Rational& radius) {
  // In coordinates about the origin.
  const BigInterval half(radius / q.unit() / Rational(2));
  const bool sphere = is_sphere(q);
  const BigInterval reach =
      BigInterval(2) * (sphere ? sine(half) / cosine(half) : hyperbolic_sine(half) / hyperbolic_cosine(half));
  std::vector<ExactPoint> points;
  for (const ExactPoint& point : q.points()) {
    const Verdict inside = less(BigInterval(pairing(point, point)), square(reach));
    if (is_undecided(inside)) return std::nullopt;
    if (is_proved(inside)) points.push_back(point);
  }
  if (points.empty() || points.front() != q.points().front()) return std::nullopt;
  return SpaceObject(q.curvature(), q.unit(), std::move(points));
}

}  // namespace delcert
