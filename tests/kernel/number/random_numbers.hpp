#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "kernel/number/interval.hpp"
#include "kernel/number/rational.hpp"
#include "tests/support/contains.hpp"

namespace delcert {

/// Numbers that are hard for an enclosure, from a fixed seed, the same for every compiler and library.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : bits_(seed) {}

  std::uint64_t below(std::uint64_t bound) { return bits_() % bound; }

  /// A double of one of nine kinds: small integers, short and long dyadics, close to 1, about 1e-160 and 1e160 (whose
  /// squares underflow and overflow), subnormals, close to overflow, any finite bit pattern.
  double hard_double() {
    // Drawn one by one: the order of evaluation of arguments is not the same everywhere.
    const double sign = below(2) == 0 ? 1 : -1;
    const double mantissa = std::ldexp(static_cast<double>(bits_() >> 11U), -52);
    const auto few = static_cast<int>(below(8));
    switch (below(9)) {
      case 0:
        return static_cast<double>(static_cast<int>(below(9)) - 4);
      case 1:
        return sign * std::ldexp(static_cast<double>(below(64)), few - 6);
      case 2:
        return sign * mantissa;
      case 3:
        return sign * std::nextafter(1.0, static_cast<double>(below(3)));
      case 4:
        return sign * std::ldexp(mantissa, -531 - few);
      case 5:
        return sign * std::ldexp(mantissa, 531 + few);
      case 6:
        return sign * std::ldexp(static_cast<double>(below(1U << 20U)), -1074);
      case 7:
        return sign * std::ldexp(mantissa, 1023);
      default: {
        const double any = std::bit_cast<double>(bits_());
        return std::isfinite(any) ? any : 0.0;
      }
    }
  }

  /// A pair lower <= upper of such doubles: equal, neighbours, a few units apart, or far apart.
  std::array<double, 2> hard_endpoints() {
    const double a = hard_double();
    double b = a;
    switch (below(4)) {
      case 0:
        break;
      case 1:
        b = std::nextafter(a, std::numeric_limits<double>::max());
        break;
      case 2:
        for (std::uint64_t step = below(6); step > 0; --step)
          b = std::nextafter(b, -std::numeric_limits<double>::max());
        break;
      default:
        b = hard_double();
    }
    return {std::min(a, b), std::max(a, b)};
  }

  Rational between(const Rational& lower, const Rational& upper) {
    switch (below(4)) {
      case 0:
        return lower;
      case 1:
        return upper;
      default: {
        const Rational weight = Rational(below(1U << 16U)) / Rational(1U << 16U);
        return lower + (upper - lower) * weight;
      }
    }
  }

  Rational between(const std::array<double, 2>& endpoints) {
    return between(Rational::exactly(endpoints[0]), Rational::exactly(endpoints[1]));
  }

 private:
  std::mt19937_64 bits_;
};

/// Whether the root of x >= 0 lies in the interval.
inline bool contains_root(const Interval& interval, const Rational& x) {
  const double lower = interval.lower();
  const double upper = interval.upper();
  if (!(lower >= 0) || !std::isfinite(lower) || std::isnan(upper)) return false;
  return square(Rational::exactly(lower)) <= x && (std::isinf(upper) || x <= square(Rational::exactly(upper)));
}

}  // namespace delcert
