#include "kernel/sample/space_form_points.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/sample/spatial_order.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_orbit_points = 16000000;
constexpr double greatest_coordinate = 0x1p30;
/// Lifts are kept a little farther than they are asked for.
constexpr double spare = 1 + 0x1p-10;
constexpr double cells_per_reach = 2;

template <int m>
Vector<PlainDouble, m> plain(const Vector<double, m>& x) {
  Vector<PlainDouble, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = PlainDouble::exactly(x[axis]);
  return result;
}

}  // namespace

template <int m>
SpaceFormPoints<m>::SpaceFormPoints(const SpaceForm& form, double reach)
    : reach_(reach),
      metric_(chart_metric<m>(form.form())),
      domain_(form, reach * spare),
      grid_(empty_grid(reach / cells_per_reach)) {}

template <int m>
LiftGrid<m> SpaceFormPoints<m>::empty_grid(double cell_width) const {
  const RoundingGuard guard;
  return LiftGrid<m>(curvature(), metric_, cell_width);
}

template <int m>
ModelPoint<Interval, m> SpaceFormPoints<m>::enclosed(const Vector<double, m>& coordinates) const {
  Vector<Interval, m> a;
  for (std::size_t axis = 0; axis < m; ++axis) a[axis] = Interval::exactly(coordinates[axis]);
  return model_point<Interval, m>(curvature(), a);
}

template <int m>
Frame<PlainDouble, m> SpaceFormPoints<m>::frame(std::uint32_t label) const {
  return Frame<PlainDouble, m>(curvature(), plain<m>(points_[label]));
}

template <int m>
std::optional<typename SpaceFormPoints<m>::Candidate> SpaceFormPoints<m>::candidate(
    const Vector<double, m>& coordinates, double least_distance) const {
  for (const double coordinate : coordinates) {
    if (!(std::abs(coordinate) < greatest_coordinate)) return std::nullopt;
  }
  const RoundingGuard guard;
  Candidate result{coordinates, enclosed(coordinates), {}};
  if (least_distance > 0 && grid_.approximately_occupied(result.place, least_distance)) return std::nullopt;
  domain_.lifts().for_each_lift(result.place, [&result](std::uint32_t number, const ModelPoint<Interval, m>& lift) {
    result.lifts.emplace_back(number, lift);
  });
  return result;
}

/// Precondition: a rounding guard is alive.
template <int m>
void SpaceFormPoints<m>::add(const Candidate& candidate) {
  if (points_.size() == most_orbit_points)
    throw Rejection("a net of this radius has more than " + std::to_string(most_orbit_points) +
                    " points, which is the most that is supported");
  const auto label = static_cast<std::uint32_t>(points_.size());
  points_.push_back(candidate.coordinates);
  for (LiftGrid<m>* grid : {&grid_, new_ ? &*new_ : nullptr}) {
    if (grid == nullptr) continue;
    grid->insert({label, {}}, candidate.place);
    for (const auto& [number, lift] : candidate.lifts) grid->insert({label, {}, number}, lift);
  }
}

template <int m>
bool SpaceFormPoints<m>::insert(const Vector<double, m>& coordinates, double least_distance) {
  const auto found = candidate(coordinates, least_distance);
  const RoundingGuard guard;
  if (found) add(*found);
  return found.has_value();
}

template <int m>
void SpaceFormPoints<m>::begin_round() {
  new_.emplace(empty_grid(reach_));  // few points, and wide queries
}

template <int m>
bool SpaceFormPoints<m>::insert_candidate(const Candidate& candidate, double least_distance) {
  const RoundingGuard guard;
  if (least_distance > 0 && new_->approximately_occupied(candidate.place, least_distance)) return false;
  add(candidate);
  return true;
}

template <int m>
bool SpaceFormPoints<m>::has_new_about(std::uint32_t label) const {
  // What a query adds to its distance grows with the grid, by less than this.
  constexpr double more = 1 + 0x1p-20;
  const RoundingGuard guard;
  return new_->approximately_occupied(enclosed(points_[label]), reach_ * more);
}

template <int m>
void SpaceFormPoints<m>::look_about(std::uint32_t label, std::vector<Vector<double, m>>& around) const {
  std::vector<Lift<m>> seen;
  {
    const RoundingGuard guard;
    grid_.near(enclosed(points_[label]), reach_, seen);
  }
  std::sort(seen.begin(), seen.end());
  around.clear();
  const auto home = frame(label);
  for (const Lift<m>& lift : seen) {
    const std::uint32_t number = lift.element;
    if (lift.index == label && number == 0) continue;
    auto x = domain_.point(points_[lift.index]);
    if (number != 0) x = applied(domain_.matrix(number), x);
    const auto conformal = home.conformal_seen(x);
    Vector<double, m> position;
    for (std::size_t axis = 0; axis < m; ++axis) position[axis] = conformal[axis].lower();
    around.push_back(metric_.approximate_cartesian(position));
  }
}

template <int m>
Vector<double, m> SpaceFormPoints<m>::at(std::uint32_t label, const Vector<double, m>& cartesian) const {
  return domain_.reduced(frame(label).applied(domain_.point(metric_.approximate_frame(cartesian))));
}

template <int m>
std::vector<Vector<Rational, m>> SpaceFormPoints<m>::ordered() const {
  std::vector<Vector<Rational, m>> result;
  result.reserve(points_.size());
  for (const std::uint32_t label : spatial_order_of_lifts<m>(curvature(), points_)) {
    Vector<Rational, m> centre;
    for (std::size_t axis = 0; axis < m; ++axis) centre[axis] = Rational::exactly(points_[label][axis]);
    result.push_back(std::move(centre));
  }
  return result;
}

template class SpaceFormPoints<2>;
template class SpaceFormPoints<3>;

}  // namespace delcert
