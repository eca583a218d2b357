#include "kernel/chart/lift_grid.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/simplex/cholesky.hpp"

namespace delcert {

namespace {

/// More than what the few operations on doubles of a query round, relative to their results.
constexpr double rounding_slack = 0x1p-40;

/// An upper bound of the chord of two points at this distance: 2 sin(d/2), d or 2 sinh(d/2).
double chord_of(Curvature curvature, double distance) {
  constexpr double most = 2 + 0x1p-40;
  if (curvature == Curvature::positive && distance >= 3) return most;
  const Interval length = Interval::exactly(distance);
  return (length * sine_ratio(curvature, square(length) / Interval(4))).upper();
}

}  // namespace

template <int m>
LiftGrid<m>::LiftGrid(Curvature curvature, const FrameMetric<m>& metric, double cell_width)
    : curvature_(curvature),
      cholesky_(upper_factor<Interval, m>(metric.template on<Interval>(), metric.gram())),
      axes_(curvature == Curvature::positive ? m + 1 : m),
      bits_(static_cast<unsigned>(64 / axes_)),
      cells_per_unit_(1 / cell_width) {}

template <int m>
typename LiftGrid<m>::Place LiftGrid<m>::embedded(const ModelPoint<Interval, m>& x, double& error) const {
  Vector<Interval, m + 1> at = x;
  Place result;
  if (curvature_ == Curvature::zero) {
    const auto cartesian = upper_applied(cholesky_, detail::spatial_part<Interval, static_cast<std::size_t>(m)>(x));
    std::copy(cartesian.begin(), cartesian.end(), at.begin());
  } else if (curvature_ == Curvature::negative) {
    const auto conformal = conformal_coordinates<Interval, m>(x);
    std::copy(conformal.begin(), conformal.end(), at.begin());
    // (1 + cosh d)/2 = 1/(1 − |a|²/4).
    result.weight = ((Interval(1) + x[0]) / Interval(2)).lower();
  }
  error = 0;
  for (std::size_t axis = 0; axis < axes_; ++axis) {
    result.at[axis] = at[axis].lower();
    error += at[axis].upper() - at[axis].lower();
  }
  return result;
}

template <int m>
double LiftGrid<m>::embedded_distance(const Place& x, double error, double distance, double chord) const {
  if (curvature_ == Curvature::positive) return chord;
  if (curvature_ == Curvature::zero) return distance;
  // |da| = (1 − |a|²/4) ds, and points within the distance of x are no closer to o than d(o, x) − distance. With
  // t = |a|/2 = tanh(d/2) that is (t − u)/(1 − tu) for u = tanh(distance/2) ≤ distance/2.
  double squared = 0;
  for (std::size_t axis = 0; axis < axes_; ++axis) squared += x.at[axis] * x.at[axis];
  const double t = (std::sqrt(squared) * (1 - rounding_slack) - error) / 2;
  const double u = distance / 2 * (1 + rounding_slack);
  const double nearest = t > u && t * u < 1 ? (t - u) / (1 - t * u) * (1 - rounding_slack) : 0;
  return distance * (1 - nearest * nearest) * (1 + rounding_slack);
}

template <int m>
std::int64_t LiftGrid<m>::cell_coordinate(double coordinate) const {
  // Points beyond the last cell are kept in it.
  const double most = static_cast<double>((std::uint64_t{1} << (bits_ - 1)) - 1);
  return static_cast<std::int64_t>(std::clamp(std::floor(coordinate * cells_per_unit_), -most, most));
}

template <int m>
std::uint64_t LiftGrid<m>::key_of(const Cell& cell) const {
  const std::uint64_t mask = (std::uint64_t{1} << bits_) - 1;
  std::uint64_t key = 0;
  for (std::size_t axis = 0; axis < axes_; ++axis)
    key = (key << bits_) | (static_cast<std::uint64_t>(cell[axis]) & mask);
  return key;
}

template <int m>
void LiftGrid<m>::insert(const Lift<m>& lift, const ModelPoint<Interval, m>& x) {
  double error = 0;
  Place place = embedded(x, error);
  error_ = std::max(error_, error);
  place.lift = lift;
  Cell cell{};
  for (std::size_t axis = 0; axis < axes_; ++axis) cell[axis] = cell_coordinate(place.at[axis]);
  const auto number = static_cast<std::uint32_t>(places_.size());
  std::uint32_t& last = cells_.at(key_of(cell));
  place.next = last;
  last = number;
  places_.push_back(place);
}

template <int m>
typename LiftGrid<m>::Distance LiftGrid<m>::measured(double distance) const {
  return {distance, chord_of(curvature_, distance)};
}

template <int m>
double LiftGrid<m>::most_chord(const Distance& distance) const {
  return distance.chord * distance.chord * (1 + 2 * rounding_slack);
}

template <int m>
typename LiftGrid<m>::Query LiftGrid<m>::query(const ModelPoint<Interval, m>& x, const Distance& distance) const {
  Query result;
  result.place = embedded(x, result.error);
  result.error += error_;
  result.reach = (embedded_distance(result.place, result.error, distance.length, distance.chord) + result.error) *
                 (1 + rounding_slack);
  // The exact points are `error` closer at most than the stored ones are, and |e(x) − e(y)| is at most `reach`:
  // (|e| − error)² ≥ |e|² − 2·error·reach.
  result.relief = 2 * result.error * result.reach * (1 + rounding_slack);
  return result;
}

template <int m>
double LiftGrid<m>::least_chord(const Query& query, const Place& other, double squared_gap) const {
  return (squared_gap * (1 - rounding_slack) - query.relief) * (query.place.weight * other.weight);
}

template <int m>
template <class Visit>
void LiftGrid<m>::visit_near(const ModelPoint<Interval, m>& x, const Distance& distance, const Visit& visit) const {
  const Query asked = query(x, distance);
  const Place& place = asked.place;
  const double reach = asked.reach;
  const double most = most_chord(distance);
  const auto is_near = [&](const Place& other) {
    const double squared = asked.squared_gap(other, axes_);
    return squared <= reach * reach * (1 + 2 * rounding_slack) && least_chord(asked, other, squared) <= most;
  };
  Cell first{};
  Cell last{};
  double count = 1;
  for (std::size_t axis = 0; axis < axes_; ++axis) {
    // Widened by what the difference and the division round.
    const double half = reach + rounding_slack * (reach + std::abs(place.at[axis]));
    first[axis] = cell_coordinate(place.at[axis] - half);
    last[axis] = cell_coordinate(place.at[axis] + half);
    count *= static_cast<double>(last[axis] - first[axis] + 1);
  }
  if (count > static_cast<double>(places_.size())) {
    for (std::uint32_t at = 0; at < places_.size(); ++at) {
      if (is_near(places_[at]) && visit(at)) return;
    }
    return;
  }
  Cell cell = first;
  while (true) {
    for (std::uint32_t at = cells_.find(key_of(cell)); at != none; at = places_[at].next) {
      if (is_near(places_[at]) && visit(at)) return;
    }
    std::size_t axis = axes_;
    while (axis > 0 && ++cell[axis - 1] > last[axis - 1]) {
      cell[axis - 1] = first[axis - 1];
      --axis;
    }
    if (axis == 0) return;
  }
}

template <int m>
void LiftGrid<m>::near(const ModelPoint<Interval, m>& x, double distance, std::vector<Lift<m>>& out) const {
  visit_near(x, measured(distance), [&](std::uint32_t number) {
    out.push_back(places_[number].lift);
    return false;
  });
}

template <int m>
std::vector<std::uint32_t> LiftGrid<m>::list_near(const ModelPoint<Interval, m>& x, const Distance& distance) const {
  thread_local std::vector<std::pair<Lift<m>, std::uint32_t>> found;
  found.clear();
  visit_near(x, distance, [&](std::uint32_t number) {
    found.emplace_back(places_[number].lift, number);
    return false;
  });
  std::sort(found.begin(), found.end());
  std::vector<std::uint32_t> result;
  result.reserve(found.size());
  for (const auto& [lift, number] : found) result.push_back(number);
  return result;
}

template <int m>
void LiftGrid<m>::near_in_list(const ModelPoint<Interval, m>& x, const Distance& listed,
                               const std::vector<std::uint32_t>& list, double distance,
                               std::vector<Lift<m>>& out) const {
  const Query asked = query(x, listed);
  const double most = most_chord(measured(distance));
  for (const std::uint32_t number : list) {
    const Place& place = places_[number];
    if (least_chord(asked, place, asked.squared_gap(place, axes_)) <= most) out.push_back(place.lift);
  }
}

template <int m>
bool LiftGrid<m>::approximately_occupied(const ModelPoint<Interval, m>& x, double distance) const {
  bool occupied = false;
  visit_near(x, measured(distance), [&occupied](std::uint32_t) { return occupied = true; });
  return occupied;
}

template class LiftGrid<2>;
template class LiftGrid<3>;

}  // namespace delcert
