#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "proofs/checker/arithmetic/formula_map.hpp"

namespace delcert::checker {

/// By how much more than a chord the distance of its ends along M is, at least and at most.
struct ChordExcess {
  double least = 0, most = std::numeric_limits<double>::infinity();
};

/// How far a point of M is from another: |x - p|, from above, and by how much more along M.
struct Distance {
  double chord;
  ChordExcess excess;
};

/// What |x - q|^2 - |x - p|^2 has to be more than, so that x is nearer to p than to q in R^N and along M: e (2 |x - p|
/// + e) with e the greatest difference of the excesses. It is infinite where nothing is known. Precondition: rounding
/// upwards.
inline double least_lead(const Distance& p, const ChordExcess& q) {
  const double e = std::max(p.excess.most - q.least, 0.0);
  return e * (2 * p.chord + e);
}

/// How far from p'_i a chart says how M bends: in all of the disc of `radius`, however little the chart shows beyond
/// it, and in as much of twice that disc as it shows with some room. Precondition of its use: the chart shows `radius`,
/// less than `shown`.
inline double reach_of_bends(double radius, double shown) {
  return std::max(radius, std::min(2 * radius, shown * 0.999));
}

/// What a chart knows of distances between points of M that it shows.
struct ChartBend {
  double stretch;             // M is no steeper than L: the root of 1 + L^2, from above
  double rate = 0, size = 0;  // along segments of the chart slopes of M change by a function with this Lipschitz
                              // constant and one that is nowhere greater than this

  /// d (rate d / sqrt 12 + size)^2 / 2: by how much the curve over a segment of the length d is longer than its chord,
  /// at most. Precondition: rounding upwards.
  double excess(double d) const;
  /// Of two points, from the square of their distance in the chart. Lemma 1 is about points that it shows: of others
  /// nothing is known. Precondition: rounding upwards.
  Distance distance(const Interval& squared, bool are_shown) const;
};

/// How a function f on R^N bends about some chords: what Lemma 3 of docs/levels/submanifolds.md asks for.
struct ChordBend {
  Matrix<Interval> gradient;  // Df at a place about the middle of the chords
  Matrix<Interval> second;    // D^2 f at all points within `room` of the chords, and between these and that place
  double room = 0;            // h
  double beside = 0;          // the place and the middle of a chord differ by this, at most

  /// For M = {f = 0} and one of the chords, between points of M: what the lemma says. Precondition: rounding upwards.
  ChordExcess excess(const Matrix<Interval>& chord) const;
};

/// About chords from points of one box to points of another; f is one function. None if the box of M has not certainly
/// all points as near, or f is not certainly defined at them. Precondition: rounding upwards.
std::optional<ChordBend> bend_about_chords(const std::vector<std::array<Quantity, 2>>& box_of_M,
                                           FormulaValues<Interval>& values, const Matrix<Interval>& from,
                                           const Matrix<Interval>& to);

}  // namespace delcert::checker
