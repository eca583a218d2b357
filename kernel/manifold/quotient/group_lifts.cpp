#include "kernel/manifold/quotient/group_lifts.hpp"

#include <algorithm>

#include "kernel/manifold/quotient/tile_walk.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert {

namespace {

Rational widened(double x) { return Rational::exactly(x) * (Rational(1) + Rational::power_of_two(-30)); }

std::vector<FieldMatrix> needed_elements(const SpaceForm& form, const LiftBounds& bounds, double reach) {
  if (form.finite) return form.finite->elements;
  if (bounds.in_polyhedron) return tiles_near_polyhedron(form.form(), *form.polyhedron, BigInterval(widened(reach)));
  return form.elements_within(widened(reach) + Rational(2) * widened(bounds.radius));
}

}  // namespace

template <int m>
GroupLifts<m>::GroupLifts(const SpaceForm& form, const LiftBounds& bounds, double reach)
    : curvature_(form.form().curvature()),
      table_(form.form(), needed_elements(form, bounds, reach), Rational(2) * form.injectivity_radius.lower) {
  const RoundingGuard guard;
  metric_ = chart_metric<m>(form.form()).template on<Interval>();
  if (bounds.in_polyhedron) polyhedron_.emplace(form.form(), *form.polyhedron);
  const Interval length = Interval::exactly(reach);
  sine_reach_ = length * sine_ratio(curvature_, square(length));
  Interval far = length + Interval::exactly(bounds.radius);
  if (curvature_ == Curvature::positive) far = minimum(far, straight_angle<Interval>());
  farthest_ = curvature_ == Curvature::zero ? square(far) : cosine_of_root(curvature_, square(far));
}

template <int m>
bool GroupLifts<m>::is_far(const ModelPoint<Interval, m>& lift) const {
  if (polyhedron_) return polyhedron_->is_certainly_farther(lift, sine_reach_);
  if (curvature_ != Curvature::zero) return is_far_from_origin(lift[0]);
  const Interval squared = metric_->squared_norm(detail::spatial_part<Interval, static_cast<std::size_t>(m)>(lift));
  return is_proved(less(farthest_, squared));
}

template <int m>
LiftBounds lift_bounds(const SpaceForm& form, const std::vector<ModelPoint<Interval, m>>& points) {
  const Curvature curvature = form.form().curvature();
  const auto metric = chart_metric<m>(form.form()).template on<Interval>();
  ModelPoint<Interval, m> origin{};
  origin[0] = Interval(1);
  LiftBounds result{0, form.polyhedron.has_value()};
  for (const auto& point : points) {
    const Interval chord = squared_chord<Interval, m>(curvature, metric, origin, point);
    result.radius = std::max(result.radius, distance_of_chord(curvature, chord).upper());
  }
  if (!result.in_polyhedron) return result;
  const EnclosedPolyhedron<m> polyhedron(form.form(), *form.polyhedron);
  result.in_polyhedron = std::all_of(points.begin(), points.end(),
                                     [&](const auto& point) { return is_proved(polyhedron.contains(point)); });
  return result;
}

template class GroupLifts<2>;
template class GroupLifts<3>;
template LiftBounds lift_bounds<2>(const SpaceForm&, const std::vector<ModelPoint<Interval, 2>>&);
template LiftBounds lift_bounds<3>(const SpaceForm&, const std::vector<ModelPoint<Interval, 3>>&);

}  // namespace delcert
