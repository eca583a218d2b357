#pragma once

#include "kernel/number/interval.hpp"
#include "kernel/number/plain_double.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert {

/// The first rung, and the guard that its operations need: intervals, always, except in the benchmark build with
/// DELCERT_PLAIN_DOUBLES, which measures what the intervals cost and certifies nothing.
#ifdef DELCERT_PLAIN_DOUBLES
using Filter = PlainDouble;
class [[nodiscard]] FilterGuard {
 public:
  FilterGuard() {}
  ~FilterGuard() {}
  FilterGuard(const FilterGuard&) = delete;
  FilterGuard& operator=(const FilterGuard&) = delete;
};
inline constexpr bool filter_is_rigorous = false;
#else
using Filter = Interval;
using FilterGuard = RoundingGuard;
inline constexpr bool filter_is_rigorous = true;
#endif

}  // namespace delcert
