#pragma once

#include <limits>
#include <optional>

#include "kernel/manifold/submanifold/dense.hpp"
#include "kernel/manifold/submanifold/zero_set.hpp"

namespace delcert {

/// By how much more than their chord the distance of two points in M is, at least and at most.
struct ChordExcess {
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
};

/// How a hypersurface M = {f = 0} bends about some chords: what Lemma 3 of docs/levels/submanifolds.md asks for.
struct ChordBend {
  Dense<Interval> gradient;  ///< Df at a place about the middle of the chords
  Dense<Interval> second;  ///< D²f, N×N, at all points within `room` of the chords, and between these and that place
  double room = 0;         ///< h
  double beside = 0;       ///< the middles of the chords are within this of the place

  /// What the lemma says of a chord, N coordinates. Needs a `RoundingGuard`.
  [[nodiscard]] ChordExcess excess(const Interval* chord) const;
};

/// About the chords from all points of one box to all of another, N coordinates each. None unless f is one function,
/// certainly defined there, and the box of the zero set has all that is so near. Needs a `RoundingGuard`.
[[nodiscard]] std::optional<ChordBend> bend_about_chords(const ZeroSet& zero_set, FormulaEvaluation<Interval>& f,
                                                         const Interval* from, const Interval* to);

}  // namespace delcert
