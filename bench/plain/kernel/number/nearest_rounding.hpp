#pragma once

// In place of kernel/number/nearest_rounding.hpp where bench/plain is the first of the folders for headers.

namespace delcert {

/// What the rounding mode is already.
class [[nodiscard]] NearestRounding {
 public:
  NearestRounding() {}
  ~NearestRounding() {}
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;
};

}  // namespace delcert
