#pragma once

#include <cmath>

#include "kernel/number/nearest_double.hpp"

namespace delcert {

/// What differs by no more than the tolerance is undecided, as a program without intervals would have it that takes
/// ties seriously: exact ties climb the ladder, and are decided there. All else is decided.
struct OrderWithTolerance {
  /// Much more than what a few operations on numbers of about 1 round, much less than margins of runs.
  static constexpr double tolerance = 0x1p-44;

  [[nodiscard]] static Verdict less(double a, double b) {
    const double difference = b - a;
    if (difference > tolerance) return Verdict::proved;
    return difference < -tolerance ? Verdict::refuted : Verdict::undecided;
  }
  [[nodiscard]] static Verdict is_zero(double a) {
    return std::fabs(a) > tolerance ? Verdict::refuted : Verdict::undecided;
  }
};

/// For measuring what intervals cost: `bench/plain/kernel/number/interval.hpp` puts it in place of `Interval`. Nothing
/// is certified.
using TolerantDouble = NearestDouble<OrderWithTolerance>;

}  // namespace delcert
