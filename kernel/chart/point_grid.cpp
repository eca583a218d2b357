#include "kernel/chart/point_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// What widens every query: far above the errors of coordinates and of the few operations on them.
constexpr double relative_slack = 0x1p-30;
constexpr double absolute_slack = 0x1p-44;

/// No more cells than this for each point, whatever the shape of the box.
constexpr double cells_per_point = 4;

}  // namespace

template <int m>
PointGrid<m>::PointGrid(const FrameMetric<m>& metric, std::optional<double> box_radius, double cell_width,
                        std::size_t expected)
    : metric_(metric), periodic_(!box_radius.has_value()), cell_width_(cell_width) {
  for (std::size_t axis = 0; axis < m; ++axis) {
    half_width_per_length_[axis] = std::sqrt(approximate_double(metric_.inverse_diagonal(axis))) * (1 + relative_slack);
    for (std::size_t column = 0; column < m; ++column) {
      gram_[axis][column] = approximate_double(metric_.gram()[axis][column]);
    }
  }
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) {
      gram_rounding_ += std::abs(gram_[row][column]) * half_width_per_length_[row] * half_width_per_length_[column];
    }
  }
  points_.reserve(expected);
  fit_box(box_radius.value_or(0), expected);
}

template <int m>
void PointGrid<m>::fit_box(double box_radius, std::size_t expected) {
  const double extent = periodic_ ? 1 : 2 * box_radius;
  double total = 1;
  for (std::size_t axis = 0; axis < m; ++axis) {
    origin_[axis] = periodic_ ? 0 : -box_radius;
    const double wanted = std::floor(extent / (cell_width_ * half_width_per_length_[axis]));
    cells_[axis] = static_cast<std::int64_t>(std::clamp(wanted, 1.0, 65536.0));
    total *= static_cast<double>(cells_[axis]);
  }
  const double most = std::max(65536.0, cells_per_point * static_cast<double>(expected));
  while (total > most) {
    auto& widest = *std::max_element(cells_.begin(), cells_.end());
    widest = (widest + 1) / 2;
    total /= 2;
  }
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < m; ++axis) {
    cells_per_unit_[axis] = static_cast<double>(cells_[axis]) / extent;
    count *= static_cast<std::size_t>(cells_[axis]);
  }
  grid_.assign(count, {});
}

template <int m>
std::uint32_t PointGrid<m>::insert(const Vector<double, m>& point) {
  const auto index = static_cast<std::uint32_t>(points_.size());
  require_moderate_coordinates<m>(index, point);
  for (const double coordinate : point) largest_coordinate_ = std::max(largest_coordinate_, std::abs(coordinate));
  points_.push_back(point);
  const Entry entry = reduce(index);
  grid_[flat_index(cell_of(entry.reduced))].push_back(entry);
  return index;
}

template <int m>
typename PointGrid<m>::Entry PointGrid<m>::reduce(std::uint32_t index) const {
  Entry entry;
  entry.index = index;
  entry.reduced = points_[index];
  if (periodic_) {
    for (std::size_t axis = 0; axis < m; ++axis) {
      const double whole = std::floor(entry.reduced[axis]);
      entry.reduced[axis] -= whole;
      entry.shift[axis] = -static_cast<std::int32_t>(whole);
    }
  }
  return entry;
}

template <int m>
std::array<std::int64_t, static_cast<std::size_t>(m)> PointGrid<m>::cell_of(const Vector<double, m>& reduced) const {
  std::array<std::int64_t, static_cast<std::size_t>(m)> cell;
  for (std::size_t axis = 0; axis < m; ++axis) {
    const double position = std::floor((reduced[axis] - origin_[axis]) * cells_per_unit_[axis]);
    cell[axis] = std::clamp<std::int64_t>(static_cast<std::int64_t>(position), 0, cells_[axis] - 1);
  }
  return cell;
}

template <int m>
std::size_t PointGrid<m>::flat_index(const std::array<std::int64_t, static_cast<std::size_t>(m)>& cell) const {
  std::size_t index = 0;
  for (std::size_t axis = 0; axis < m; ++axis) {
    index = index * static_cast<std::size_t>(cells_[axis]) + static_cast<std::size_t>(cell[axis]);
  }
  return index;
}

template <int m>
double PointGrid<m>::size_with(const Vector<double, m>& centre) const {
  double size = largest_coordinate_;
  for (const double coordinate : centre) size = std::max(size, std::abs(coordinate));
  return size;
}

template <int m>
double PointGrid<m>::widened(double distance, double size) {
  return distance * (1 + relative_slack) + absolute_slack * size;
}

template <int m>
double PointGrid<m>::most_squared(const Vector<double, m>& centre, double distance) const {
  // Rounding in xᵀGx, with every |x_a| below its half-width, relative to the square of the distance.
  const double reach = widened(distance, size_with(centre));
  return reach * reach * (1 + 0x1p-48 * gram_rounding_);
}

template <int m>
template <class Visit>
void PointGrid<m>::visit_near(const Vector<double, m>& centre, double distance, const Visit& visit) const {
  using Index = std::array<std::int64_t, static_cast<std::size_t>(m)>;
  Index first;
  Index last;
  const double size = size_with(centre);
  const double reach = widened(distance, size);
  for (std::size_t axis = 0; axis < m; ++axis) {
    const double half = reach * half_width_per_length_[axis] + absolute_slack * size;
    first[axis] = static_cast<std::int64_t>(std::floor((centre[axis] - half - origin_[axis]) * cells_per_unit_[axis]));
    last[axis] = static_cast<std::int64_t>(std::floor((centre[axis] + half - origin_[axis]) * cells_per_unit_[axis]));
    if (!periodic_) {
      // Points beyond the box live in its outermost cells.
      first[axis] = std::clamp<std::int64_t>(first[axis], 0, cells_[axis] - 1);
      last[axis] = std::clamp<std::int64_t>(last[axis], 0, cells_[axis] - 1);
    }
  }
  const double most = most_squared(centre, distance);
  // A cell by its number in the unit cell and by how many periods it is away.
  struct Wrapped {
    std::int64_t cell;
    std::int32_t period;
  };
  const auto wrapped_at = [&](std::size_t axis, std::int64_t cell) -> Wrapped {
    // Usually: a division takes long.
    if (!periodic_ || (cell >= 0 && cell < cells_[axis])) return {cell, 0};
    std::int64_t turns = cell / cells_[axis];
    if (turns * cells_[axis] > cell) --turns;
    return {cell - turns * cells_[axis], static_cast<std::int32_t>(turns)};
  };
  constexpr std::size_t along = m - 1;
  // Of a long row of cells, only those that may be near: about half of the box is not. Points are at most a rounding
  // error outside of their cells, which is far below the slack.
  constexpr std::int64_t long_row = 4;
  const bool narrows = periodic_ && metric_.is_cartesian() && last[along] - first[along] >= long_row;
  const double slack = 2 * absolute_slack * size;
  Vector<double, m> width;
  for (std::size_t axis = 0; axis < m; ++axis) width[axis] = 1 / cells_per_unit_[axis];
  const auto gap = [&](std::size_t axis, std::int64_t cell) {
    const double low = origin_[axis] + static_cast<double>(cell) * width[axis] - centre[axis];
    return std::max(0.0, std::max(low, -low - width[axis]) - slack);
  };
  Index row = first;
  Index place{};
  Shift<m> period{};
  for (std::size_t axis = 0; axis < along; ++axis) {
    const Wrapped start = wrapped_at(axis, row[axis]);
    place[axis] = start.cell;
    period[axis] = start.period;
  }
  const Index first_place = place;
  const Shift<m> first_period = period;
  while (true) {
    std::int64_t begin = first[along];
    std::int64_t end = last[along];
    if (narrows) {
      double rest = most * (1 + relative_slack);
      for (std::size_t axis = 0; axis < along; ++axis) {
        const double here = gap(axis, row[axis]);
        rest -= here * here;
      }
      if (rest < 0) {
        end = begin - 1;
      } else {
        const double half = std::sqrt(rest) + slack;
        const auto cell_at = [&](double coordinate) {
          return static_cast<std::int64_t>(std::floor((coordinate - origin_[along]) * cells_per_unit_[along]));
        };
        begin = std::max(begin, cell_at(centre[along] - half));
        end = std::min(end, cell_at(centre[along] + half));
      }
    }
    if (begin <= end) {
      const Wrapped start = wrapped_at(along, begin);
      place[along] = start.cell;
      period[along] = start.period;
    }
    for (std::int64_t cell = begin; cell <= end; ++cell) {
      const Cell& entries = grid_[flat_index(place)];
      if constexpr (requires { visit.expect(entries.size()); }) visit.expect(entries.size());
      for (const Entry& entry : entries) {
        Vector<double, m> offset;
        for (std::size_t axis = 0; axis < m; ++axis) {
          offset[axis] = entry.reduced[axis] + static_cast<double>(period[axis]) - centre[axis];
        }
        if constexpr (requires { visit.consider(entry, period, true); }) {
          visit.consider(entry, period, squared_norm(offset) <= most);
        } else if (squared_norm(offset) <= most && visit(entry, period)) {
          return;
        }
      }
      if (++place[along] == cells_[along] && periodic_) {
        place[along] = 0;
        ++period[along];
      }
    }
    std::size_t axis = along;
    while (axis > 0 && ++row[axis - 1] > last[axis - 1]) {
      row[axis - 1] = first[axis - 1];
      place[axis - 1] = first_place[axis - 1];
      period[axis - 1] = first_period[axis - 1];
      --axis;
    }
    if (axis == 0) return;
    if (++place[axis - 1] == cells_[axis - 1] && periodic_) {
      place[axis - 1] = 0;
      ++period[axis - 1];
    }
  }
}

namespace {

/// Takes what is near. No processor predicts which of the points in cells are: all are written, and what is not near is
/// written over.
template <int m>
struct Nearby {
  std::vector<Lift<m>>& out;
  std::size_t& count;

  void expect(std::size_t more) const {
    if (out.size() < count + more) out.resize(2 * count + more + 64);
  }
  template <class Entry>
  void consider(const Entry& entry, const Shift<m>& period, bool is_near) const {
    Lift<m>& lift = out[count];
    lift.index = entry.index;
    lift.shift = sum_of<m>(entry.shift, period);
    count += static_cast<std::size_t>(is_near);
  }
};

}  // namespace

template <int m>
void PointGrid<m>::near(const Vector<double, m>& centre, double distance, std::vector<Lift<m>>& out) const {
  std::size_t count = out.size();
  visit_near(centre, distance, Nearby<m>{out, count});
  out.resize(count);
}

template <int m>
bool PointGrid<m>::approximately_occupied(const Vector<double, m>& centre, double distance) const {
  // Usually by a point of the same cell, which takes much less time to find out than where the others begin.
  const double most = most_squared(centre, distance);
  const Cell& home = grid_[flat_index(cell_of(centre))];
  bool occupied = std::any_of(home.begin(), home.end(), [&](const Entry& entry) {
    return squared_norm(difference(entry.reduced, centre)) <= most;
  });
  if (occupied) return true;
  visit_near(centre, distance, [&occupied](const Entry&, const Shift<m>&) { return occupied = true; });
  return occupied;
}

template <int m>
std::vector<std::uint32_t> PointGrid<m>::spatial_order() const {
  std::vector<std::pair<std::uint64_t, std::size_t>> cells;
  std::array<std::int64_t, static_cast<std::size_t>(m)> cell{};
  for (std::size_t flat = 0; flat < grid_.size(); ++flat) {
    std::size_t rest = flat;
    for (std::size_t back = 0; back < m; ++back) {
      const std::size_t axis = m - 1 - back;
      cell[axis] = static_cast<std::int64_t>(rest % static_cast<std::size_t>(cells_[axis]));
      rest /= static_cast<std::size_t>(cells_[axis]);
    }
    std::uint64_t code = 0;
    for (unsigned bit = 0; bit < 16; ++bit) {
      for (std::size_t axis = 0; axis < m; ++axis) {
        code |= ((static_cast<std::uint64_t>(cell[axis]) >> bit) & 1U) << (std::size_t{bit} * m + axis);
      }
    }
    cells.emplace_back(code, flat);
  }
  std::sort(cells.begin(), cells.end());
  std::vector<std::uint32_t> order;
  order.reserve(points_.size());
  for (const auto& [code, flat] : cells) {
    for (const Entry& entry : grid_[flat]) order.push_back(entry.index);
  }
  return order;
}

#define DELCERT_INSTANTIATE(m) template class PointGrid<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
