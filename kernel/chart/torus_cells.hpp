#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernel/chart/point_grid.hpp"

namespace delcert {

/// Points of ℝᵐ/ℤᵐ in the cells of the unit cube, for "all lifts in a box": where lengths are measured otherwise in
/// every place, a box is what all of them have in common.
template <int m>
class TorusCells {
 public:
  /// `widths`: about the usual width of a box along each axis. Precondition: above 0.
  explicit TorusCells(const Vector<double, m>& widths) {
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < m; ++axis) {
      cells_[axis] = static_cast<std::int64_t>(std::min(std::max(std::floor(1 / widths[axis]), 1.0), most_cells));
      count *= static_cast<std::size_t>(cells_[axis]);
    }
    entries_.resize(count);
  }

  /// Adds a point. Precondition: coordinates in [0, 1), each within 2⁻⁵⁰ of the exact one.
  void insert(std::uint32_t index, const Vector<double, m>& point) {
    std::size_t flat = 0;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const std::int64_t cell = std::min(cell_of(axis, point[axis]), cells_[axis] - 1);
      flat = flat * static_cast<std::size_t>(cells_[axis]) + static_cast<std::size_t>(cell);
    }
    entries_[flat].push_back(index);
  }

  /// Calls visit(Lift<m>) for every lift whose exact coordinates differ from the centre's by at most the half-widths,
  /// and for others near by; until it returns true. In whatever rounding mode. Precondition: the centre is in [0, 1)ᵐ
  /// up to 2⁻⁵⁰.
  template <class Visit>
  void visit(const Vector<double, m>& centre, const Vector<double, m>& half_widths, const Visit& visit) const {
    using Index = std::array<std::int64_t, static_cast<std::size_t>(m)>;
    Index first;
    Index last;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const double reach = half_widths[axis] * (1 + slack) + slack;
      first[axis] = cell_of(axis, centre[axis] - reach);
      last[axis] = cell_of(axis, centre[axis] + reach);
    }
    for (Index cell = first;;) {
      Shift<m> shift;
      std::size_t flat = 0;
      for (std::size_t axis = 0; axis < m; ++axis) {
        std::int64_t turns = cell[axis] / cells_[axis];
        if (turns * cells_[axis] > cell[axis]) --turns;
        shift[axis] = static_cast<std::int32_t>(turns);
        flat =
            flat * static_cast<std::size_t>(cells_[axis]) + static_cast<std::size_t>(cell[axis] - turns * cells_[axis]);
      }
      for (const std::uint32_t index : entries_[flat]) {
        if (visit(Lift<m>{index, shift})) return;
      }
      std::size_t axis = m;
      while (axis > 0 && ++cell[axis - 1] > last[axis - 1]) {
        cell[axis - 1] = first[axis - 1];
        --axis;
      }
      if (axis == 0) return;
    }
  }

 private:
  /// Far above the roundings of coordinates of lifts near the unit cube, and of cells.
  static constexpr double slack = 0x1p-36;
  static constexpr double most_cells = m == 2 ? 512 : 64;

  [[nodiscard]] std::int64_t cell_of(std::size_t axis, double x) const {
    return static_cast<std::int64_t>(std::floor(x * static_cast<double>(cells_[axis])));
  }

  std::array<std::int64_t, static_cast<std::size_t>(m)> cells_{};
  std::vector<std::vector<std::uint32_t>> entries_;
};

}  // namespace delcert
