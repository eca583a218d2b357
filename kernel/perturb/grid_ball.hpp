#pragma once

#include "kernel/chart/atlas.hpp"
#include "kernel/random/counter_random.hpp"

namespace delcert {

/// The points of a dyadic grid in a ball of a local metric, to draw from uniformly. Preconditions of everything: a
/// `FilterGuard` is alive.
template <int m>
class GridBall {
 public:
  /// All x with |x − centre| ≤ radius and coordinates that are multiples of 2^exponent. `enclosed` is the metric on the
  /// filter; references to the metrics are kept.
  GridBall(const FrameMetric<m>& metric, const MetricOn<Filter, m>& enclosed, const Vector<Rational, m>& centre,
           const Rational& radius, long exponent);

  /// Draws the next point; the same whatever the rounding of enclosures.
  void draw(CounterRandom& random);
  /// Enclosures of its coordinates.
  [[nodiscard]] const Vector<Filter, m>& enclosure() const { return enclosure_; }
  [[nodiscard]] Vector<Rational, m> exact() const;

 private:
  /// The grid points of a box that holds the ball have the coordinates first, first + step, … .
  struct Axis {
    Rational first;
    Integer count;
    unsigned bits = 0;       // of count
    Filter from_zero;        // first
    Filter from_centre;      // first − centre
    std::uint64_t few = 0;   // count, if it has at most 52 bits
    std::uint64_t chosen{};  // how many steps, if it has
    Integer chosen_of_many;  // otherwise
  };

  static void choose(CounterRandom& random, Axis& axis);
  /// Of that many steps.
  [[nodiscard]] Filter length(const Axis& axis) const;
  [[nodiscard]] bool is_in_ball() const;

  const FrameMetric<m>& metric_;
  const MetricOn<Filter, m>& enclosed_;
  Vector<Rational, m> centre_;
  Rational squared_radius_;
  Filter enclosed_squared_radius_;
  Rational step_;
  Filter enclosed_step_;
  Vector<Axis, m> axes_;
  Vector<Filter, m> enclosure_{};
  Vector<Filter, m> from_centre_{};
};

}  // namespace delcert
