#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/chart/cell_table.hpp"
#include "kernel/chart/model_space.hpp"
#include "kernel/chart/point_grid.hpp"

namespace delcert {

/// Points of a model space, each a lift of a point of its quotient, in cells, for "all lifts within a distance".
///
/// The cells are cubes of an embedding e with |e(x) − e(y)| ≤ d(x, y): the linear model of the sphere, Cartesian
/// coordinates of 𝔼ᵐ, conformal ones of ℍᵐ (|da| ≤ ds). Points come as enclosures; how wide these are is kept, and
/// every query is widened by it, so that none of the exact points within the distance is missed; some that are slightly
/// farther are returned, too (by a relative 2⁻³⁰ where enclosures are about as narrow as doubles are and the distance
/// is 2⁻¹⁶ or more).
template <int m>
class LiftGrid {
 public:
  /// `metric`: that of the frame for curvature 0, else Cartesian. `cell_width`: about the usual distance of queries.
  /// Needs a `RoundingGuard`, as everything that takes enclosures does.
  LiftGrid(Curvature curvature, const FrameMetric<m>& metric, double cell_width);

  [[nodiscard]] std::size_t size() const { return places_.size(); }
  void reserve(std::size_t lifts) { places_.reserve(lifts); }

  /// Adds a lift that is somewhere in the enclosure.
  void insert(const Lift<m>& lift, const ModelPoint<Interval, m>& x);

  /// Appends to `out` a superset of the lifts within `distance` of x. Their order depends on what was inserted, in
  /// which order.
  void near(const ModelPoint<Interval, m>& x, double distance, std::vector<Lift<m>>& out) const;

  /// A distance, with an upper bound of the chord of points so far from each other.
  struct Distance {
    double length = 0;
    double chord = 0;
  };
  [[nodiscard]] Distance measured(double distance) const;

  /// The numbers of what `near` finds, in the order of the lifts: a list that can be asked for less than this distance
  /// later.
  [[nodiscard]] std::vector<std::uint32_t> list_near(const ModelPoint<Interval, m>& x, const Distance& distance) const;
  /// Appends to `out` what `near` would find within `distance`, and possibly lifts that are farther by what is rounded,
  /// in the order of the lifts. Precondition: the list is of this point and of the distance `listed`, which is not
  /// less.
  void near_in_list(const ModelPoint<Interval, m>& x, const Distance& listed, const std::vector<std::uint32_t>& list,
                    double distance, std::vector<Lift<m>>& out) const;

  /// Whether some lift is closer to x than `distance`, or by a relative 2⁻³⁰ farther.
  [[nodiscard]] bool approximately_occupied(const ModelPoint<Interval, m>& x, double distance) const;

 private:
  static constexpr std::uint32_t none = CellTable::none;
  using Embedded = Vector<double, m + 1>;
  using Cell = Vector<std::int64_t, m + 1>;

  /// Where a point is embedded, and w with w(x)·w(y)·|e(x) − e(y)|² = the squared chord of x and y: at most that, as it
  /// is rounded downwards. Every coordinate is rounded downwards, too, by `error` in all.
  struct Place {
    Embedded at{};
    double weight = 1;
    Lift<m> lift{};
    std::uint32_t next = none;
  };
  [[nodiscard]] Place embedded(const ModelPoint<Interval, m>& x, double& error) const;
  /// A bound of |e(x) − e(y)| for all y within the distance of x, whose place has this error.
  [[nodiscard]] double embedded_distance(const Place& x, double error, double distance, double chord) const;

  /// What is compared with the place of a lift to see whether it is near a point.
  struct Query {
    Place place;
    double error;   // of both places
    double reach;   // of the embedding
    double relief;  // of a squared chord
    [[nodiscard]] double squared_gap(const Place& other, std::size_t axes) const {
      double squared = 0;
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const double step = other.at[axis] - place.at[axis];
        squared += step * step;
      }
      return squared;
    }
  };
  [[nodiscard]] Query query(const ModelPoint<Interval, m>& x, const Distance& distance) const;
  /// A lower bound of the squared chord of the point and a lift, by the gap between their places.
  [[nodiscard]] double least_chord(const Query& query, const Place& other, double squared_gap) const;
  /// The upper bound of squared chords that are compared with those.
  [[nodiscard]] double most_chord(const Distance& distance) const;

  /// visit(number): whether that is enough.
  template <class Visit>
  void visit_near(const ModelPoint<Interval, m>& x, const Distance& distance, const Visit& visit) const;
  [[nodiscard]] std::int64_t cell_coordinate(double coordinate) const;
  [[nodiscard]] std::uint64_t key_of(const Cell& cell) const;

  Curvature curvature_;
  Matrix<Interval, m> cholesky_{};  // upper triangular; Cartesian coordinates = this · frame coordinates
  std::size_t axes_;                // how many coordinates the embedding has
  unsigned bits_;                   // of each in a key
  double cells_per_unit_;
  double error_ = 0;  // of the lift whose enclosure is widest
  std::vector<Place> places_;
  CellTable cells_;  // to the last place of each cell that has some
};

}  // namespace delcert
