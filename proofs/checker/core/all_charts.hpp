#pragma once

#include "proofs/checker/core/powers_around.hpp"

namespace delcert::checker {

/// What is known of a simplex in the space; all lengths are squared chords.
struct SimplexInSpace {
  Vector<Interval> centre{};  // C, with the first vertex at the lift of the identity
  double radius = 0;          // from C to the vertices, at most
  double nearest = 0;         // from C to all points of P' that are no vertices, at least
  double eigenvalue = 0;      // of the Gram matrix of the edges at a vertex, at least; 0 or less if it is not known
  double altitude = 0;        // of the straight simplex, the least, at least
  double longest = 0;         // edge, at most
};

/// Finds that out. Precondition: the rules of Theorem C4 hold, and m is 2 or 3.
class SimplicesInSpace {
 public:
  explicit SimplicesInSpace(core::Complex& complex) : complex_(complex), form_(complex.data), around_(complex) {}
  SimplexInSpace of(std::uint32_t s);

 private:
  core::Complex& complex_;
  const core::Form<Interval> form_;
  core::PowersAround around_;
};

/// What follows of it in the charts that show all of the simplex and its circumcentre within `reach` of their centres
/// (docs/levels/space-forms.md, In all charts). All lengths are those in a chart.
class AllCharts {
 public:
  /// Nothing follows if the reach is a quarter of a great circle or more.
  AllCharts(int K, std::size_t m, const Quantity& reach);

  struct Bounds {
    bool known = false;
    double centre = 0;                 // how far the circumcentre is from where the chart shows C, at most
    double radius = 0;                 // the circumradius, at most
    double nearest = 0;                // from the circumcentre to all points of P' that are no vertices, at least
    double altitude = 0, longest = 0;  // the squares of the least altitude, at least, and of the longest edge, at most
  };
  Bounds bounds(const SimplexInSpace& simplex) const;
  /// Whether in all of them the circumradius is at most `radius`, the thickness at least `thickness`, and all points
  /// of P' that are no vertices are farther than circumradius + protection from the circumcentre.
  bool fits(const SimplexInSpace& simplex, const Quantity& radius, const Quantity& thickness,
            const Quantity& protection) const;

  /// The square of the chord of an arc of this length, at least.
  double squared_chord(double length) const;

 private:
  int K_;
  std::size_t m_;
  bool is_narrow_;
  // The squares of lengths in a chart are at least and at most so many times the squares of chords.
  Interval least_{1}, most_{1};
};

}  // namespace delcert::checker
