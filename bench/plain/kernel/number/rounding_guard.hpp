#pragma once

// In place of kernel/number/rounding_guard.hpp where bench/plain is the first of the folders for headers.

namespace delcert {

/// Doubles are rounded to nearest: there is nothing to switch.
class [[nodiscard]] RoundingGuard {
 public:
  RoundingGuard() {}
  ~RoundingGuard() {}
  RoundingGuard(const RoundingGuard&) = delete;
  RoundingGuard& operator=(const RoundingGuard&) = delete;
};

}  // namespace delcert
