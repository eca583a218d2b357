#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernel/simplex/frame_metric.hpp"
#include "support/error.hpp"

namespace delcert {

/// An integer vector of the frame: a translation of the lattice ℤᵐ.
template <int m>
using Shift = std::array<std::int32_t, static_cast<std::size_t>(m)>;

template <int m>
[[nodiscard]] Shift<m> sum_of(const Shift<m>& a, const Shift<m>& b) {
  Shift<m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = a[axis] + b[axis];
  return result;
}

template <int m>
[[nodiscard]] Shift<m> difference_of(const Shift<m>& a, const Shift<m>& b) {
  Shift<m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = a[axis] - b[axis];
  return result;
}

/// One lift of a point: the point with this index, moved by a lattice vector or by an element of a group.
template <int m>
struct Lift {
  std::uint32_t index = 0;
  Shift<m> shift{};
  std::uint32_t element = 0;  ///< its number in the group's list; 0 is the identity
  friend auto operator<=>(const Lift&, const Lift&) = default;

  /// Whether it is the point itself.
  [[nodiscard]] bool is_unmoved() const { return shift == Shift<m>{} && element == 0; }
};

/// Throws InputError, naming the label, for a coordinate of 2³⁰ or more: the shifts of its lifts need not fit.
template <int m>
void require_moderate_coordinates(std::uint32_t label, const Vector<double, m>& point) {
  for (const double coordinate : point) {
    if (!(std::abs(coordinate) < 0x1p30)) {
      throw InputError("label " + std::to_string(label) + " has a coordinate of 2^30 or more: use a point nearer to 0");
    }
  }
}

/// Points of ℝᵐ/ℤᵐ (or of a bounded part of ℝᵐ) in cells, for "all lifts within a distance".
///
/// The grid works on double approximations of the coordinates, which must be within 2⁻⁵⁰·max(1, |coordinate|) of the
/// exact ones; queries are widened, in proportion to the largest coordinate of all, so that none of the exact points
/// within the distance is missed, and return some points that are slightly farther.
template <int m>
class PointGrid {
 public:
  /// `box_radius`: none for ℝᵐ/ℤᵐ; otherwise cells cover the box [−r, r]ᵐ, the outermost ones also what lies beyond.
  /// `cell_width`: a length, about the usual query distance. `expected`: about how many points there will be.
  PointGrid(const FrameMetric<m>& metric, std::optional<double> box_radius, double cell_width, std::size_t expected);

  /// Adds a point; returns its index. Precondition: moderate coordinates, otherwise InputError is thrown.
  std::uint32_t insert(const Vector<double, m>& point);

  /// Appends to `out` a superset of the lifts within `distance` of `centre`. The order depends on the points only.
  void near(const Vector<double, m>& centre, double distance, std::vector<Lift<m>>& out) const;

  /// The same, to ask again about what was found for a greater distance: a lift belongs to the answer if its
  /// `squared_distance` is at most `most_squared`.
  [[nodiscard]] double squared_distance(const Vector<double, m>& centre, std::uint32_t index,
                                        const Vector<double, m>& shift) const {
    Vector<double, m> offset;
    for (std::size_t axis = 0; axis < m; ++axis) offset[axis] = points_[index][axis] + shift[axis] - centre[axis];
    return squared_norm(offset);
  }
  [[nodiscard]] double most_squared(const Vector<double, m>& centre, double distance) const;

  /// Whether some lift is closer to `centre` than `distance`, without error bounds.
  [[nodiscard]] bool approximately_occupied(const Vector<double, m>& centre, double distance) const;

  /// The indices in the order of cells along a space-filling (Morton) curve.
  [[nodiscard]] std::vector<std::uint32_t> spatial_order() const;

  [[nodiscard]] const std::vector<Vector<double, m>>& points() const { return points_; }

 private:
  struct Entry {
    Vector<double, m> reduced;  // in the unit cell if periodic
    Shift<m> shift{};           // reduced = point + shift
    std::uint32_t index = 0;
  };
  using Cell = std::vector<Entry>;

  [[nodiscard]] Entry reduce(std::uint32_t index) const;
  [[nodiscard]] std::array<std::int64_t, static_cast<std::size_t>(m)> cell_of(const Vector<double, m>& reduced) const;
  [[nodiscard]] std::size_t flat_index(const std::array<std::int64_t, static_cast<std::size_t>(m)>& cell) const;
  template <class Visit>
  void visit_near(const Vector<double, m>& centre, double distance, const Visit& visit) const;
  void fit_box(double box_radius, std::size_t expected);
  /// The greatest coordinate of all points and this one, or 1.
  [[nodiscard]] double size_with(const Vector<double, m>& centre) const;
  /// So far the grid looks where a distance is asked for.
  [[nodiscard]] static double widened(double distance, double size);
  /// In a Cartesian frame the same number without the products by 0 and 1.
  [[nodiscard]] double squared_norm(const Vector<double, m>& offset) const {
    if (metric_.is_cartesian()) return pairing(offset, offset);
    double squared = 0;
    for (std::size_t row = 0; row < m; ++row) squared += offset[row] * pairing(gram_[row], offset);
    return squared;
  }

  FrameMetric<m> metric_;
  Matrix<double, m> gram_{};
  Vector<double, m> half_width_per_length_{};  // upper bound of √(G⁻¹)_aa
  double gram_rounding_ = 0;                   // Σ |G_ab|·√(G⁻¹)_aa·√(G⁻¹)_bb: how much xᵀGx may cancel
  bool periodic_;
  double cell_width_;
  double largest_coordinate_ = 1;  // of the points, or 1
  std::vector<Vector<double, m>> points_;
  Vector<double, m> origin_{};
  Vector<double, m> cells_per_unit_{};
  std::array<std::int64_t, static_cast<std::size_t>(m)> cells_{};
  std::vector<Cell> grid_;
};

}  // namespace delcert
