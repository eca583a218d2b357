#pragma once

#include <cstdint>
#include <vector>

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

  /// From now on the ball about this centre with this radius, on the same grid.
  void move_to(const Vector<Rational, m>& centre, const Rational& radius);

 private:
  void take_radius(const Rational& radius);
  void take_centre(const Vector<Rational, m>& centre);
  /// The grid points of a box that holds the ball have the coordinates first, first + step, … .
  struct Axis {
    Rational first;
    Integer count;
    unsigned bits = 0;  // of count
    unsigned rest = 0;  // of these, how many come after the first 52
    std::uint64_t head_of_count = 0;
    Filter from_zero;                  // first
    Filter from_centre;                // first − centre
    Filter unit;                       // a length of 2^rest steps
    std::vector<std::uint32_t> words;  // how many steps were chosen, 32 bits each, the last word what remains of them
    std::uint64_t head = 0;            // the first 52 bits of that
  };

  static void choose(CounterRandom& random, Axis& axis);
  /// What its words begin with.
  [[nodiscard]] static std::uint64_t head_of(const Axis& axis);
  [[nodiscard]] static Integer chosen(const Axis& axis);
  /// Of the chosen steps.
  [[nodiscard]] static Filter length(const Axis& axis);
  /// By doubles.
  [[nodiscard]] Verdict is_clearly_outside() const;
  void enclose();
  [[nodiscard]] bool is_in_ball() const;

  const FrameMetric<m>& metric_;
  const MetricOn<Filter, m>& enclosed_;
  Vector<Rational, m> centre_;
  Rational radius_;
  Rational squared_radius_;
  Vector<Rational, m> halves_;  // of the sides of the box
  Filter enclosed_squared_radius_;
  long exponent_;
  Rational step_;
  Vector<Axis, m> axes_;
  Vector<Filter, m> enclosure_{};
  Vector<Filter, m> from_centre_{};
};

}  // namespace delcert
