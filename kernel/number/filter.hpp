#pragma once

#include "kernel/number/interval.hpp"
#include "kernel/number/plain_double.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert {

/// The first rung, and the guard that its operations need.
using Filter = Interval;
using FilterGuard = RoundingGuard;

/// False in the benchmark build only, which measures what intervals cost and certifies nothing: it has the headers of
/// bench/plain/ in the place of this one and of those above.
inline constexpr bool filter_is_rigorous = true;

}  // namespace delcert
