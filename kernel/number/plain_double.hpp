#pragma once

#include "kernel/number/nearest_double.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

/// As doubles are, rounded as they may be.
struct OrderOfDoubles {
  [[nodiscard]] static Verdict less(double a, double b) { return verdict_of(a < b); }
  [[nodiscard]] static Verdict is_zero(double a) { return verdict_of(a == 0); }
};

/// A double whose verdicts are always proved or refuted, and may be wrong. For what is proposed or chosen by, on which
/// nothing rests.
using PlainDouble = NearestDouble<OrderOfDoubles>;

/// A double next to x.
template <>
[[nodiscard]] inline PlainDouble scalar_from<PlainDouble>(const Rational& x) {
  return PlainDouble::exactly(approximate_double(x));
}

}  // namespace delcert
