#pragma once

#include <CGAL/Interval_nt.h>

namespace delcert {

/// While one of these lives, the floating-point unit of this thread rounds upwards, which every operation on
/// `Interval` requires. Nothing that expects rounding to nearest (CGAL triangulations, printing of doubles,
/// approximate code) may run under it.
class [[nodiscard]] RoundingGuard {
 public:
  RoundingGuard() = default;
  RoundingGuard(const RoundingGuard&) = delete;
  RoundingGuard& operator=(const RoundingGuard&) = delete;

 private:
  CGAL::Protect_FPU_rounding<true> protection_;
};

}  // namespace delcert
