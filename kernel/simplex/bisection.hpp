#pragma once

#include <utility>

#include "kernel/number/rational.hpp"

namespace delcert {

/// A number between two rational bounds: lower ≤ x ≤ upper.
struct RationalBounds {
  Rational lower;
  Rational upper;
};

/// Bounds of a number 0 < x ≤ upper by bisection, until upper − lower ≤ 2^−bits · upper.
/// `is_at_least(t)` tells exactly whether x ≥ t.
template <class Predicate>
[[nodiscard]] RationalBounds bisected(Rational upper, unsigned bits, const Predicate& is_at_least) {
  RationalBounds bounds{Rational(0), std::move(upper)};
  const Rational width = Rational::power_of_two(-static_cast<long>(bits));
  while (bounds.upper - bounds.lower > width * bounds.upper) {
    const Rational middle = (bounds.lower + bounds.upper) / Rational(2);
    (is_at_least(middle) ? bounds.lower : bounds.upper) = middle;
  }
  return bounds;
}

}  // namespace delcert
