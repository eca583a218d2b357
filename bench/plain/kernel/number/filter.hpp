#pragma once

// In place of kernel/number/filter.hpp where bench/plain is the first of the folders for headers.

#include "kernel/number/interval.hpp"
#include "kernel/number/plain_double.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert {

/// What measures the cost of intervals and certifies nothing.
using Filter = Interval;
using FilterGuard = RoundingGuard;
inline constexpr bool filter_is_rigorous = false;

}  // namespace delcert
