#include "kernel/stars/rounded_balls.hpp"

#include <algorithm>
#include <cmath>

namespace delcert {

namespace {

// In a unit between once and twice the sampling radius. What is larger is left to intervals.
constexpr double most_radius = 2;
constexpr double most_reach = 16;
constexpr double most_edge = 4;
constexpr double most_protection = 0.5;
constexpr double most_size = 16;
constexpr double most_error = 0x1p-30;
/// Of the centre and the radius of a ball when points around it are looked for.
constexpr double slack = 0x1p-10;

}  // namespace

template <int m>
template <class S>
struct RoundedBalls<m>::Room {
  S radius;
  S reach;
  S shape;

  Room(const SimplexForm<S, m>& form, const Vector<S, m>& first, const Limits<S>& limits)
      : radius(limits.doubled_radius * form.sphere.weight - form.sphere.norm),
        reach(limits.doubled_reach * form.sphere.weight - form.sphere.norm -
              norm(sum(scaled(S(form.sphere.weight + form.sphere.weight), first), form.sphere.normal))),
        shape(form.sphere.weight * form.sphere.weight - limits.squared_thickness * form.breadth) {}
};

template <int m>
void RoundedBalls<m>::look(const ChartView<m>& view, const LocalMargins& margins) {
  take_places(view);
  compare_with(margins);
}

template <int m>
void RoundedBalls<m>::take_places(const ChartView<m>& view) {
  const FilterGuard guard;
  is_usable_ = false;
  if (!view.filter_metric().is_cartesian()) return;
  int exponent = 0;
  (void)std::frexp(approximate_double(view.atlas().sampling_radius(view.chart())), &exponent);
  scale_ = std::ldexp(1.0, -exponent);
  complete_ = view.complete_radius(LocalCoordinates::chart);
  place_.resize(view.size());
  double size = 0;
  double error = 0;
  for (std::size_t at = 0; at < view.size(); ++at) {
    const auto& position = view.position(LocalCoordinates::chart, at);
    for (std::size_t axis = 0; axis < m; ++axis) {
      const double lower = position[axis].lower() * scale_;
      const double width = (Filter::exactly(position[axis].upper()) - Filter::exactly(position[axis].lower())).upper();
      place_[at][axis] = lower;
      if (!(std::fabs(lower) <= size)) size = std::fabs(lower);
      if (!(width <= error)) error = width;
    }
  }
  error *= scale_;
  if (!(size <= most_size) || !(error <= most_error)) return;
  // Few values, so that bounds are seldom computed anew.
  size_ = std::ceil(2 * size + 1) / 2;
  int error_exponent = -100;
  if (error > 0x1p-100) (void)std::frexp(error, &error_exponent);
  take_bounds(size_, std::ldexp(1.0, error_exponent));
  sort_places();
  is_usable_ = true;
}

template <int m>
void RoundedBalls<m>::take_bounds(double size, double error) {
  if (bounds_.size == size && bounds_.error == error) return;
  using Bound = RoundingBound;
  Vector<Bound, m> place;
  place.fill(Bound::of(size + error, error));
  const Vector<Bound, m> offset = difference(place, place);
  Vector<Bound, m> edge = offset;
  for (Bound& coordinate : edge) coordinate = coordinate.at_most(most_edge * (1 + 0x1p-20));
  std::array<Vector<Bound, m>, static_cast<std::size_t>(m)> edges;
  edges.fill(edge);
  Vector<Bound, m> squared;
  squared.fill(pairing(edge, edge).at_most(most_edge * most_edge));
  const SimplexForm<Bound, m> form(edges, squared);
  const Limits<Bound> limits{Bound::of(2 * most_radius, 0), Bound::of(2 * most_reach, 0),
                             Bound::of(most_protection * (2 * most_radius + most_protection), 0), Bound(m * m)};
  const Room<Bound> room(form, place, limits);
  bounds_.size = size;
  bounds_.error = error;
  bounds_.most_squared_edge = (most_edge * most_edge - squared[0].error()) * (1 - 0x1p-40);
  bounds_.of_radius = room.radius.error();
  bounds_.of_reach = room.reach.error();
  bounds_.of_shape = room.shape.error();
  bounds_.of_power = form.sphere.power(offset, pairing(offset, offset) - limits.power).error();
  // Then the quotients by twice the weight are wrong by less than a quarter of the slack.
  bounds_.least_weight =
      (form.sphere.normal[0].error() + form.sphere.norm.error() + 2 * (most_radius + 1) * form.sphere.weight.error()) *
      (2 / slack);
}

template <int m>
std::size_t RoundedBalls<m>::row_of(double coordinate) const {
  const double row = (coordinate + size_) * rows_per_unit_;
  return row <= 0 ? 0 : std::min(rows - 1, static_cast<std::size_t>(row));
}

template <int m>
void RoundedBalls<m>::sort_places() {
  rows_per_unit_ = static_cast<double>(rows) / (2 * size_);
  first_in_cell_.fill(0);
  cell_.resize(place_.size());
  for (std::size_t at = 0; at < place_.size(); ++at) {
    cell_[at] = static_cast<std::uint16_t>(row_of(place_[at][0]) * rows + row_of(place_[at][1]));
    ++first_in_cell_[cell_[at] + 1U];
  }
  for (std::size_t cell = 0; cell < rows * rows; ++cell) first_in_cell_[cell + 1] += first_in_cell_[cell];
  auto next = first_in_cell_;
  for (auto& coordinates : sorted_) coordinates.resize(place_.size());
  for (std::size_t at = 0; at < place_.size(); ++at) {
    const std::uint32_t to = next[cell_[at]]++;
    for (std::size_t axis = 0; axis < m; ++axis) sorted_[axis][to] = place_[at][axis];
  }
}

template <int m>
void RoundedBalls<m>::compare_with(const LocalMargins& margins) {
  is_comparable_ = false;
  if (!is_usable_) return;
  const FilterGuard guard;
  const auto scaled_up = [this](double length) { return Filter::exactly(length) * Filter::exactly(scale_); };
  const Filter protection = scaled_up(margins.protection);
  const Filter radius = scaled_up(margins.circumradius);
  const Filter thickness = Filter::exactly(margins.thickness);
  // A ball that reaches no farther has all points around it in the view.
  const Filter reach = minimum(scaled_up(margins.reach), scaled_up(complete_) - protection);
  if (!(margins.protection > 0 && margins.thickness > 0 && margins.thickness <= 1 && reach.lower() > 0)) return;
  if (!(protection.upper() <= most_protection && radius.upper() <= most_radius && reach.upper() <= most_reach)) return;
  protection_ = protection.upper();
  limits_.doubled_radius = (radius + radius).lower();
  limits_.doubled_reach = (reach + reach).lower();
  limits_.power = (protection * (radius + radius + protection)).upper();
  limits_.squared_thickness = (Filter(m * m) * square(thickness)).upper();
  is_comparable_ = true;
}

/// How many of these places have a power above the limit, certainly.
template <int m>
std::size_t RoundedBalls<m>::count_beyond(const SphereForm<double, m>& sphere, const Vector<double, m>& first,
                                          std::size_t begin, std::size_t end) const {
  std::size_t result = 0;
  for (std::size_t at = begin; at < end; ++at) {
    Vector<double, m> offset;
    for (std::size_t axis = 0; axis < m; ++axis) offset[axis] = sorted_[axis][at] - first[axis];
    const double power = sphere.power(offset, pairing(offset, offset) - limits_.power);
    result += power > bounds_.of_power ? 1 : 0;
  }
  return result;
}

template <int m>
bool RoundedBalls<m>::are_met_by(const PlaceSimplex<m>& simplex) const {
  if (!is_comparable_) return false;
  const Vector<double, m>& first = place_[simplex[0]];
  std::array<Vector<double, m>, static_cast<std::size_t>(m)> edges;
  Vector<double, m> squared;
  for (std::size_t k = 0; k < m; ++k) {
    edges[k] = difference(place_[simplex[k + 1]], first);
    squared[k] = pairing(edges[k], edges[k]);
    if (!(squared[k] < bounds_.most_squared_edge)) return false;
  }
  const SimplexForm<double, m> form(edges, squared);
  const SphereForm<double, m>& sphere = form.sphere;
  if (!(sphere.weight > bounds_.least_weight)) return false;
  const Room<double> room(form, first, limits_);
  if (!(room.radius > bounds_.of_radius && room.reach > bounds_.of_reach && room.shape > bounds_.of_shape))
    return false;

  // What is outside of this square about the centre is beyond the ball.
  const double half = sphere.norm / (2 * sphere.weight) + protection_ + slack;
  const double across = first[0] + sphere.normal[0] / (2 * sphere.weight);
  const double along = first[1] + sphere.normal[1] / (2 * sphere.weight);
  const std::size_t last_row = row_of(across + half);
  const std::size_t lowest = row_of(along - half);
  const std::size_t highest = row_of(along + half);
  std::size_t not_beyond = 0;
  for (std::size_t row = row_of(across - half); row <= last_row; ++row) {
    const std::size_t begin = first_in_cell_[row * rows + lowest];
    const std::size_t end = first_in_cell_[row * rows + highest + 1];
    not_beyond += end - begin - count_beyond(sphere, first, begin, end);
  }
  // The vertices themselves are on the sphere.
  return not_beyond == m + 1;
}

template class RoundedBalls<2>;
template class RoundedBalls<3>;

}  // namespace delcert
