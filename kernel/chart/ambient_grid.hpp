#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace delcert {

/// Points of ℝᴺ, N ≤ 9 known at run time only, in cubes, for "all points within a distance".
class AmbientGrid {
 public:
  /// `cell_width`: about twice the usual distance of queries. Precondition: above 0.
  AmbientGrid(std::size_t dimension, double cell_width)
      : dimension_(dimension), cells_per_unit_(1 / cell_width), bits_(63 / static_cast<unsigned>(dimension)) {}

  [[nodiscard]] std::size_t size() const { return next_.size(); }
  /// The point with this number.
  [[nodiscard]] const double* operator[](std::size_t point) const { return &places_[point * dimension_]; }

  /// Adds a point, x[N]; its number is how many there were.
  void insert(const double* x) {
    places_.insert(places_.end(), x, x + dimension_);
    std::uint64_t key = 0;
    for (std::size_t axis = 0; axis < dimension_; ++axis) key = with(key, cell_of(x[axis]));
    const auto [found, is_new] = first_.try_emplace(key, none);
    next_.push_back(found->second);
    found->second = static_cast<std::uint32_t>(next_.size() - 1);
  }

  /// Calls visit(number, squared distance) for every point within the distance, and a few that are farther by a
  /// relative 2⁻³⁰, until it returns true; in an order that depends on what was inserted. In whatever rounding mode.
  template <class Visit>
  void visit(const double* x, double distance, const Visit& visit) const {
    constexpr double slack = 1 + 0x1p-30;
    std::int64_t first[9];
    std::int64_t last[9];
    std::int64_t at[9];
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      first[axis] = at[axis] = cell_of(x[axis] - distance * slack);
      last[axis] = cell_of(x[axis] + distance * slack);
    }
    const double most = distance * distance * slack;
    while (true) {
      std::uint64_t key = 0;
      for (std::size_t axis = 0; axis < dimension_; ++axis) key = with(key, at[axis]);
      if (const auto found = first_.find(key); found != first_.end()) {
        for (std::uint32_t point = found->second; point != none; point = next_[point]) {
          const double* place = &places_[point * dimension_];
          double squared = 0;
          for (std::size_t axis = 0; axis < dimension_; ++axis)
            squared += (place[axis] - x[axis]) * (place[axis] - x[axis]);
          if (squared <= most && visit(point, squared)) return;
        }
      }
      std::size_t axis = 0;
      while (axis < dimension_ && ++at[axis] > last[axis]) {
        at[axis] = first[axis];
        ++axis;
      }
      if (axis == dimension_) return;
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  [[nodiscard]] std::int64_t cell_of(double x) const {
    return static_cast<std::int64_t>(std::floor(x * cells_per_unit_));
  }
  /// Cells that are 2^bits apart share a key; a query sees fewer, and looks at distances.
  [[nodiscard]] std::uint64_t with(std::uint64_t key, std::int64_t cell) const {
    return key << bits_ | (static_cast<std::uint64_t>(cell) & ((std::uint64_t{1} << bits_) - 1));
  }

  std::size_t dimension_;
  double cells_per_unit_;
  unsigned bits_;
  std::vector<double> places_;
  std::vector<std::uint32_t> next_;
  std::unordered_map<std::uint64_t, std::uint32_t> first_;
};

}  // namespace delcert
