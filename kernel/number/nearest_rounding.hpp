#pragma once

#include <CGAL/Interval_nt.h>

namespace delcert {

/// While one of these lives, the floating-point unit of this thread rounds to nearest, under a `RoundingGuard` too:
/// for approximate code on a path that has one. No operation on `Interval` may run under it.
class [[nodiscard]] NearestRounding {
 public:
  NearestRounding() : protection_(CGAL_FE_TONEAREST) {}
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;

 private:
  CGAL::Protect_FPU_rounding<true> protection_;
};

}  // namespace delcert
