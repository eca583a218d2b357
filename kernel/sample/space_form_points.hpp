#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "kernel/chart/lift_grid.hpp"
#include "kernel/sample/space_form_domain.hpp"

namespace delcert {

template <int m>
struct SpaceFormNet {
  /// Conformal coordinates of one lift of each point, the one nearest to o (for curvature 0: coordinates of the frame).
  /// Multiples of 2⁻⁴⁸, and doubles. In the order of a space-filling curve.
  std::vector<Vector<Rational, m>> centres;
  /// In doubles, without error bounds: the greatest distance of a point of M from the net, the least in it.
  double covering_radius = 0;
  double separation = 0;
};

/// Points of a space form that is being sampled, with the lifts within a reach of each; in doubles, without error
/// bounds. Everything needs rounding to nearest. What is const may be asked by several threads at a time.
template <int m>
class SpaceFormPoints {
 public:
  /// A point that may be added, with its lifts.
  struct Candidate {
    Vector<double, m> coordinates{};
    ModelPoint<Interval, m> place{};
    std::vector<std::pair<std::uint32_t, ModelPoint<Interval, m>>> lifts;  // by elements
  };

  SpaceFormPoints(const SpaceForm& form, double reach);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] Curvature curvature() const { return domain_.curvature(); }
  [[nodiscard]] const SpaceFormDomain<m>& domain() const { return domain_; }

  /// Adds a point by its coordinates, unless some lift of another is within the distance, or the coordinates are 2³⁰ or
  /// more (−o has none); says whether it did. Throws Rejection for more than 16 000 000 points.
  bool insert(const Vector<double, m>& coordinates, double least_distance);

  /// The point with these coordinates, for `insert_candidate`; none under the same conditions.
  [[nodiscard]] std::optional<Candidate> candidate(const Vector<double, m>& coordinates, double least_distance) const;
  /// From here on points are new.
  void begin_round();
  /// Adds a candidate unless some lift of a new point is within the distance: of the others none is, if it was made in
  /// this round with this distance. Says whether it did. Throws as `insert`. Precondition: a round has begun.
  bool insert_candidate(const Candidate& candidate, double least_distance);
  /// Whether the answer of `look_about` may have changed in this round. Precondition: a round has begun.
  [[nodiscard]] bool has_new_about(std::uint32_t label) const;

  /// The lifts within the reach of a point but itself, seen from it: Cartesian conformal coordinates.
  void look_about(std::uint32_t label, std::vector<Vector<double, m>>& around) const;
  /// The coordinates of the point that is seen there from a label.
  [[nodiscard]] Vector<double, m> at(std::uint32_t label, const Vector<double, m>& cartesian) const;

  /// The points, exactly, in the order of a space-filling curve.
  [[nodiscard]] std::vector<Vector<Rational, m>> ordered() const;

 private:
  [[nodiscard]] LiftGrid<m> empty_grid(double cell_width) const;
  void add(const Candidate& candidate);
  [[nodiscard]] ModelPoint<Interval, m> enclosed(const Vector<double, m>& coordinates) const;
  [[nodiscard]] Frame<PlainDouble, m> frame(std::uint32_t label) const;

  double reach_;
  FrameMetric<m> metric_;
  SpaceFormDomain<m> domain_;
  LiftGrid<m> grid_;
  std::optional<LiftGrid<m>> new_;  // the lifts of new points; none before the first round
  std::vector<Vector<double, m>> points_;
};

}  // namespace delcert
