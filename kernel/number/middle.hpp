#pragma once

#include "kernel/number/interval.hpp"

namespace delcert {

/// A double near the middle, in the interval, for what need not be exact; in whatever rounding mode. Precondition: the
/// ends are finite, and so is their difference.
[[nodiscard]] inline double middle_of(const Interval& x) { return x.lower() + (x.upper() - x.lower()) / 2; }

}  // namespace delcert
